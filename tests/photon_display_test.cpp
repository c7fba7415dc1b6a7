// SPDX-License-Identifier: MIT
#include "gather/photons/photon_display.h"

#include <doctest/doctest.h>

#include "accel/build.h"
#include "core/hair_points.h"
#include "tools/check/support/small_scenes.h"
#include "tools/check/support/surface_photons.h"

using namespace tress;
using namespace tress::test;

namespace {

constexpr TypeSet kShown = {false, false, false, true, true};

Vec3 random_direction(uint64_t key, uint64_t i) {
    const float u = random(key, 2 * i), v = random(key, 2 * i + 1);
    return sample_uniform_sphere({u, v});
}

/// Straight fibers of one segment, at random in the unit ball; some thick, some thin, and dense on one side.
PlacedHair hair_ball(size_t fibers, const Fiber& fiber) {
    PlacedHair hair;
    hair.strands.first = {0};
    for (uint64_t i = 0; i < fibers; ++i) {
        const float distance = std::cbrt(random(1, i)), thickness = random(2, i);
        Vec3 middle = distance * random_direction(3, i);
        if (i % 2 == 0) middle.x = std::abs(middle.x);
        const Vec3 along = 0.1f * random_direction(4, i);
        for (const Vec3& end : {middle - along, middle + along}) {
            hair.strands.add_point(end);
            hair.strands.radius.push_back(0.001f + 0.002f * thickness);
        }
        hair.strands.first.push_back(uint32_t(hair.strands.points()));
    }
    hair.fiber = fiber;
    return hair;
}

uint32_t nearest_segment_axis(const SegmentView& segments, const Vec3& p) {
    uint32_t nearest = 0;
    float best = kInfinity;
    for (uint32_t s = 0; s < segments.size(); ++s) {
        const Vec3 axis = segments.end(s) - segments.start(s), to = p - segments.start(s);
        const float t = glm::clamp(dot(to, axis) / dot(axis, axis), 0.0f, 1.0f), d = glm::length(to - t * axis);
        if (d < best) best = d, nearest = s;
    }
    return nearest;
}

/// Photons that light of radiance 1 from everywhere leaves on hair: on a fiber they arrive in proportion to
/// cos theta, and bring pi^2 x diameter x length.
PhotonList photons_of_white_sky(const SegmentView& segments, size_t n) {
    const HairPoints points = spread_points(segments, n);
    PhotonList list;
    for (uint64_t i = 0; i < points.position.size(); ++i) {
        const uint32_t s = nearest_segment_axis(segments, points.position[i]);
        const Vec3 tangent = normalize(segments.end(s) - segments.start(s));
        Vec3 direction;
        float cosine = 0;
        for (uint64_t trial = 0;; ++trial) {
            direction = random_direction(hash(5, i), trial);
            cosine = safe_sqrt(1 - square(dot(direction, tangent)));
            if (random(hash(6, i), trial) < cosine) break;
        }
        const PathType type = i % 4 == 0 ? PathType::type4 : PathType::type5;
        add(list, {points.position[i], direction, Rgb(square(kPi) * points.area), type}, cosine);
    }
    return list;
}

ShadingPoint point_on_fiber(const SegmentView& segments, uint64_t i) {
    const uint32_t s = uint32_t(hash(7, i) % segments.size());
    ShadingPoint point;
    point.position = glm::mix(segments.start(s), segments.end(s), random(8, i));
    const Vec3 eye = random_direction(9, i);
    point.frame = fiber_frame(normalize(segments.end(s) - segments.start(s)), eye);
    point.wo = point.frame.to_local(eye);
    point.segment = s;
    point.fiber = 0;
    point.h = 2 * random(10, i) - 1;
    return point;
}

}  // namespace

TEST_CASE("photons of a white sky make white fibers white, a quarter by one type and the rest by the other") {
    FiberParameters rough;  // white; its lobes are wide, so that few photons say much
    rough.beta_m = rough.beta_n = 0.8f;
    const Scene scene = assemble({hair_ball(3000, make_fiber(rough))}, {}, {}, {});
    PreparedScene prepared;
    prepared.segments = view(scene.hair, scene.segments);
    const Options options;
    prepared.photons.shown = make_shown_photons(photons_of_white_sky(prepared.segments, 20'000), {}, kShown,
                                                prepared.segments, options.photons);
    std::vector<ShadingPoint> points;
    for (uint64_t i = 0; i < 2000; ++i) points.push_back(point_on_fiber(prepared.segments, i));
    std::vector<LightByType> light(points.size());
    PhotonDisplay display;
    display(scene, prepared, options, points, light);
    double sum = 0, squares = 0, type4 = 0;
    for (const LightByType& l : light) {
        const double all = double(l[3].x + l[4].x);
        sum += all;
        squares += all * all;
        type4 += double(l[3].x);
        REQUIRE((std::isfinite(all) && l[0] == Rgb(0) && l[1] == Rgb(0) && l[2] == Rgb(0)));
    }
    const double n = double(points.size()), mean = sum / n;
    // Points share photons: 20,000 with 50 to an estimate are as good as 400 points that share none.
    const double error = std::sqrt((squares / n - mean * mean) / 400);
    CHECK(error < 0.03);
    CHECK(std::abs(mean - 1) < 3 * error + 0.005);
    CHECK(std::abs(type4 / sum - 0.25) < 3 * error);
}

TEST_CASE("photons on a square show as albedo / pi times their irradiance, at its edge too") {
    const TriangleMesh mesh = unit_square();
    PhotonList photons = uniform_photons(mesh, 40'000, 2.0, PathType::type4);
    append(photons, uniform_photons(mesh, 10'000, 100.0, PathType::type1));  // not shown
    Scene scene;
    scene.mesh = mesh;
    const Options options;
    PreparedScene prepared;
    prepared.mesh = build_triangle_tree(mesh, options.accel);
    prepared.photons.shown = make_shown_photons({}, photons, kShown, {}, options.photons);
    std::vector<ShadingPoint> points(2000);
    for (uint64_t i = 0; i < points.size(); ++i) {
        const float u = random(1, i), v = 0.03f * random(2, i);
        points[i].position = points[i].on_surface = {u, v, 0};
        points[i].geometric_normal = {0, 0, 1};
        points[i].color = Rgb(0.5f, 0.25f, 0);
    }
    std::vector<LightByType> light(points.size());
    PhotonDisplay display;
    display(scene, prepared, options, points, light);
    double sum = 0;
    for (const LightByType& l : light) {
        CHECK((l[0] == Rgb(0) && l[4] == Rgb(0)));
        CHECK(l[3].y == doctest::Approx(double(l[3].x) / 2));
        sum += double(l[3].x);
    }
    // 0.03 of the square holds 1200 photons: sd 2.9 %.
    CHECK(sum / double(points.size()) == doctest::Approx(0.5 / 3.14159265 * 2).epsilon(3 / std::sqrt(1200.0)));
}

TEST_CASE("points on hair are spread by area, whatever the taper") {
    PlacedHair hair = upright_fibers({{0, 0}, {1, 0}}, 1, 0.1f, white_fiber());
    hair.strands.constant_radius = 0;
    hair.strands.radius = {0.3f, 0, 0.1f, 0.1f};  // areas 0.6 and 0.4
    const Scene scene = assemble({hair}, {}, {}, {});
    const HairPoints points = spread_points(view(scene.hair, scene.segments), 1000);
    REQUIRE(points.position.size() == 1000);
    CHECK(points.area == doctest::Approx(1e-3));
    size_t thick = 0, lower_half = 0;
    for (const Vec3& p : points.position) {
        const bool first = p.x < scene.bounds.center().x;
        thick += first;
        lower_half += first && p.y < 0;
    }
    CHECK(std::abs(int(thick) - 600) <= 1);
    CHECK(std::abs(int(lower_half) - 450) <= 1);  // three quarters of a triangle
}

TEST_CASE("no photons show nothing; one, and many at one point, are finite") {
    const Scene scene = assemble({hair_ball(10, white_fiber())}, {}, {}, {});
    PreparedScene prepared;
    prepared.segments = view(scene.hair, scene.segments);
    const Options options;
    const ShadingPoint point = point_on_fiber(prepared.segments, 1);
    for (const int n : {0, 1, 2, 3000}) {
        PhotonList photons;
        for (int i = 0; i < n; ++i)
            add(photons, {point.position, point.frame.to_world({0, 0, -1}), Rgb(1), PathType::type5}, 1.0f);
        prepared.photons.shown = make_shown_photons(photons, {}, kShown, prepared.segments, options.photons);
        std::vector<LightByType> light(1);
        PhotonDisplay display;
        display(scene, prepared, options, {&point, 1}, light);
        CAPTURE(n);
        CHECK(is_finite(light[0][4]));
        CHECK((n > 0 || light[0] == LightByType{}));
    }
}
