// SPDX-License-Identifier: MIT
// Stiff cases of hair queries: thin hair seen from far, rays along the axis, ten thousand layers.
#include <doctest/doctest.h>

#include "accel/build.h"
#include "core/frame.h"
#include "tests/oracle.h"
#include "tests/tree_scenes.h"

using namespace tress;
using namespace tress::scenes;

namespace {

struct Errors {
    double wrong = 0;    // share of rays that hit where they should miss, or the other way round
    double t_error = 0;  // 99th percentile, in radii
};

/// Rays from `distance` radii away that pass a lone hair of unit length at up to two radii from its axis.
Errors errors_at(double distance, size_t count) {
    constexpr float kThin = 35e-4f;
    Errors errors;
    std::vector<double> t_errors;
    Dice dice(21);
    Hair hair;
    hair.add(Vec3(-0.31f, 0.2f, 0.11f), Vec3(0.6f, -0.13f, 0.24f), kThin);
    const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
    const oracle::Scene scene(hair.view());
    const DVec3 start(hair.view().start(0)), end(hair.view().end(0));
    Rays rays;
    for (size_t i = 0; i < count; ++i) {
        const DVec3 d(dice.direction());
        const double along = dice.unit(), side = 2 * double(dice.both());
        const DVec3 across = normalize(cross(d, end - start));
        const DVec3 through = start + along * (end - start) + side * double(kThin) * across;
        rays.add(Vec3(through - distance * double(kThin) * d), Vec3(d));
    }
    const Nearest found = nearest(tree, rays.batch());
    for (size_t i = 0; i < count; ++i) {
        const auto near = oracle::approaches(scene, oracle::ray_of(rays.batch(), i));
        const bool hit = !near.empty() && near[0].offset <= 1;
        errors.wrong += double(hit != (found.id[i] == 0)) / double(count);
        if (hit && found.id[i] == 0)
            t_errors.push_back(std::abs(double(found.t[i]) - double(float(near[0].t))) / double(kThin));
    }
    std::nth_element(t_errors.begin(), t_errors.begin() + long(t_errors.size() * 99 / 100), t_errors.end());
    errors.t_error = t_errors[t_errors.size() * 99 / 100];
    return errors;
}

}  // namespace

TEST_CASE("thin hair seen from far away is hit where it should be") {
    const Errors near = errors_at(3e4, 100000), far = errors_at(3e5, 100000);
    MESSAGE("wrong at 3e4 radii: " << near.wrong << ", at 3e5: " << far.wrong << "; t off by " << near.t_error
                                   << " and " << far.t_error << " radii");
    CHECK(near.wrong <= 2e-4);
    CHECK(far.wrong <= 5e-3);
    CHECK(near.t_error <= 0.01);
}

TEST_CASE("no ray along the axis, through the tip or from inside a hair is lost") {
    constexpr float kThick = 0.05f;
    Dice dice(22);
    size_t lost = 0, rays_traced = 0;
    for (int k = 0; k < 50; ++k) {
        Hair hair;
        const Vec3 start = dice.in_cube(), way = dice.direction(), end = start + way;
        hair.add(start, end, kThick);
        const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
        const Frame frame = frame_about(way);
        Rays rays;
        for (int i = 0; i < 2000; ++i) {
            const float angle = 2 * kPi * dice.unit(), r = 0.99f * kThick * std::sqrt(dice.unit());
            const Vec3 off = r * (std::cos(angle) * frame.x + std::sin(angle) * frame.y);
            rays.add(start + off - 2.0f * way, way);  // along the axis
            rays.add(end + off + 2.0f * way, -way);   // and back
            const Vec3 d = dice.direction();
            rays.add(end + 0.99f * kThick * dice.unit() * cross(d, frame.x) - 3.0f * d,
                     d);  // through the ball at the tip
        }
        for (const uint32_t id : nearest(tree, rays.batch()).id) lost += id == kNone;
        rays_traced += rays.size();
    }
    CHECK(rays_traced == 300000);
    CHECK(lost == 0);
}

TEST_CASE("a ray that starts inside a hair meets it where it passes the axis ahead, and nowhere behind") {
    const float radius = 0.1f;
    Hair hair;
    hair.add(Vec3(-1, 0, 0), Vec3(1, 0, 0), radius);
    const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
    Dice dice(23);
    Rays rays;
    for (int i = 0; i < 1000; ++i) rays.add(Vec3(0, 0, 0.09f * dice.both()), Vec3(0.3f * dice.both(), 0, -1));
    const Nearest found = nearest(tree, rays.batch());
    for (size_t i = 0; i < rays.size(); ++i) {
        CAPTURE(rays.oz[i]);
        CHECK((found.id[i] == 0) == (rays.oz[i] >= 0));
        if (found.id[i] == 0) CHECK(found.t[i] == doctest::Approx(rays.oz[i]).epsilon(1e-5));
    }
}

TEST_CASE("ten thousand layers are counted to the last") {
    constexpr int kLayers = 10000;
    Hair hair;
    for (int i = 0; i < kLayers; ++i) {
        const float z = 0.01f * float(i);
        hair.add(Vec3(-1, 0, z), Vec3(1, 0, z), 0.02f);
    }
    const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
    Rays rays;
    Dice dice(24);
    for (int i = 0; i < 200; ++i)
        rays.add(Vec3(0.5f * dice.both(), 0.01f * dice.both(), i % 2 ? -1.0f : 200.0f), Vec3(0, 0, i % 2 ? 1 : -1));
    for (const uint32_t crossings : constant(tree, rays.batch(), 0.999f, 0).crossings) CHECK(crossings == kLayers);
    constexpr uint32_t kFirstBelow = 6905;  // log(1e-3) / log(0.999) = 6904.3
    for (const uint32_t crossings : constant(tree, rays.batch(), 0.999f, 1e-3f).crossings)
        CHECK(crossings == kFirstBelow);
    Attenuation attenuation;
    attenuation.table.resize(1);
    attenuation.table[0].depth.assign(AttenuationTable::kRows, Rgb(1e-3f, 1e-4f, 1e-5f));
    std::vector<Rgb> through(rays.size());
    transmittance(tree, rays.batch(), attenuation, 0, through, Isa::automatic);
    for (const Rgb& t : through) {
        CHECK(t.x == doctest::Approx(std::exp(-10.0)).epsilon(1e-5));
        CHECK(t.y == doctest::Approx(std::exp(-1.0)).epsilon(1e-5));
        CHECK(t.z == doctest::Approx(std::exp(-0.1)).epsilon(1e-5));
    }
}

TEST_CASE("of many hairs at one place the one of the smallest number is nearest") {
    Hair hair;
    for (int i = 0; i < 5000; ++i) hair.add(Vec3(-1, 0.1f, 0.3f), Vec3(1, 0.2f, -0.3f), 0.05f);
    const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
    Rays rays;
    Dice dice(25);
    for (int i = 0; i < 100; ++i) rays.add(Vec3(0.5f * dice.both(), 0.15f, 3), Vec3(0, 0, -1));
    const Nearest found = nearest(tree, rays.batch());
    const Constant through = constant(tree, rays.batch(), 0.5f, 0);
    for (size_t i = 0; i < rays.size(); ++i) {
        CHECK(found.id[i] == 0);
        CHECK(through.crossings[i] == 5000);
    }
}
