// SPDX-License-Identifier: MIT
#include "gather/projection/light_probe.h"

#include <doctest/doctest.h>

#include "accel/isa_targets.h"
#include "core/rng.h"
#include "core/sampler.h"
#include "core/sampling.h"
#include "gather/projection/make_light_probe.h"
#include "tools/check/support/projected_hair.h"
#include "tools/check/support/small_scenes.h"

using namespace tress;
using namespace tress::test;

namespace {

constexpr float kHalf = 2;  // of the square in z = 0

/// Hair about a black square, which ends sight within it; or far before it.
struct BeforeSquare {
    Scene scene;
    Options options = small_options();
    Plan plan;
    PreparedScene prepared;

    explicit BeforeSquare(bool among) {
        std::vector<Vec2> xz;
        for (int i = 0; i < 20; ++i) xz.push_back({-1 + 0.1f * float(i), among ? -1 + 0.1f * float(i) : 3.0f});
        scene = assemble({upright_fibers(xz, 1.5f, 0.01f, white_fiber())}, {square(kHalf, Rgb(0))},
                         {EnvironmentLight{"", {}, Rgb(1), 0}}, camera_on_z(6, 40, 8));
        options.type1 = LampMethod::off;
        options.type3 = CrossingMethod::off;
        options.type2 = GatherMethod::projection;
        plan = make_plan(scene, options);
        prepared = prepare(scene, plan, options);
    }

    LightProbe probe(const Vec3& at) const {
        return make_light_probe(scene, prepared, plan, igloo(), at, Excluded{}, 7, options.isa);
    }
    const Igloo& igloo() const { return prepared.probes->igloo(); }
};

/// Distance of the square along a direction; infinity: past it.
float square_distance(const Vec3& from, const Vec3& direction, const DVec3& origin) {
    const Vec3 world = from + Vec3(origin);
    const float t = -world.z / direction.z;
    if (!(t > 0)) return kInfinity;
    const Vec3 at = world + t * direction;
    return std::max(std::abs(at.x), std::abs(at.y)) < kHalf ? t : kInfinity;
}

}  // namespace

TEST_CASE("a probe sees polygons at their distance, and the sky past them") {
    const BeforeSquare s(true);
    const Vec3 at = Vec3(0.3f, -0.2f, 0.7f) - Vec3(s.scene.origin);
    const LightProbe probe = s.probe(at);
    const uint32_t cells = s.igloo().cells_of(Dome::sphere);
    REQUIRE(probe.cells.size() == cells);
    int agree = 0, among = 0;
    for (uint32_t cell = 0; cell < cells; ++cell) {
        const Vec3 middle(s.igloo().center_x[cell], s.igloo().center_y[cell], s.igloo().center_z[cell]);
        const float exact = square_distance(at, probe.frame.to_world(middle), s.scene.origin);
        agree += (exact == kInfinity) == probe.cells[cell].is_sky();
        among += probe.cells[cell].is_among_hair();
    }
    // Rays are anywhere in their cells: of about 30 cells along each of the square's sides some go past it.
    CHECK(agree > int(0.9 * cells));
    CHECK(among > int(0.2 * cells));
}

TEST_CASE("a probe is read where a point beside it looks") {
    const BeforeSquare s(false);
    const Vec3 at = Vec3(0, 0, 0.5f) - Vec3(s.scene.origin), beside = at + Vec3(0.3f, 0.2f, -0.2f);
    const LightProbe probe = s.probe(at);
    const auto seen_in = [&](uint32_t cell) {  // on the square, at the middle of a cell
        const Vec3 middle(s.igloo().center_x[cell], s.igloo().center_y[cell], s.igloo().center_z[cell]);
        return at + probe.cells[cell].distance() * probe.frame.to_world(middle);
    };
    double off_read = 0, off_beside = 0;
    for (uint64_t i = 0; i < 2000; ++i) {
        Vec3 direction = sample_uniform_sphere({tress::random(i, 0), tress::random(i, 1)});
        direction.z = -std::abs(direction.z);
        const uint32_t read = cell_towards(probe, s.igloo(), beside, direction);
        const uint32_t here = cell_of(s.igloo(), probe.frame.to_local(direction));
        const float distance = square_distance(beside, direction, s.scene.origin);
        if (!(distance < 1) || probe.cells[read].is_sky() || probe.cells[here].is_sky()) continue;
        const Vec3 exact = beside + distance * direction;
        off_read += double(length(seen_in(read) - exact));
        off_beside += double(length(seen_in(here) - exact));
    }
    CHECK(off_read < 0.5 * off_beside);
}

TEST_CASE("a ball close by hides as much of the wall behind it as it does from where the point is") {
    constexpr double kRadius = 10, kWall = 60;  // a head in a room
    const auto distance = [&](const DVec3& from, const DVec3& direction) {
        const double along = dot(from, direction), out = dot(from, from);
        const double meets = along * along - out + kRadius * kRadius;
        if (meets > 0 && along < 0) return -along - std::sqrt(meets);
        return -along + std::sqrt(along * along - out + kWall * kWall);
    };
    const auto is_ball = [](double d) { return d < 20; };  // at most 4.6 away; the wall is 49 and more
    const Igloo igloo = make_igloo(256);
    constexpr uint32_t kDirections = 4096, kFrames = 4;
    /// Share of directions in which a point at a height sees the ball, by probes at another.
    const auto hidden = [&](double height, double by_probe_at) {
        int count = 0;
        for (uint64_t i = 0; i < kFrames; ++i) {
            LightProbe probe;
            probe.position = Vec3(0.3f, 0, float(kRadius + by_probe_at));
            probe.frame = random_frame(i);
            for (uint32_t cell = 0; cell < igloo.cells_of(Dome::sphere); ++cell) {
                const Vec2 u(random(hash(i, cell), 0), random(hash(i, cell), 1));
                const DVec3 direction(probe.frame.to_world(direction_in(igloo, cell, u)));
                probe.cells.push_back({float(distance(DVec3(probe.position), direction)), {}});
            }
            for (uint32_t k = 0; k < kDirections; ++k) {
                const Vec3 direction = sample_uniform_sphere(Sampler{hash(9, i), k}.get2(0));
                const Vec3 place(0, 0, float(kRadius + height));
                count += is_ball(double(probe.cells[cell_towards(probe, igloo, place, direction)].distance()));
            }
        }
        return double(count) / (kDirections * kFrames);
    };
    for (const double height : {0.2, 0.4, 0.6}) {
        CAPTURE(height);
        constexpr double kLow = 0.05, kHigh = 1;  // corners of a cube of the grid, drawn by their weights
        const double upper = (height - kLow) / (kHigh - kLow);
        const double by_probes = (1 - upper) * hidden(height, kLow) + upper * hidden(height, kHigh);
        const double out = kRadius + height, exact = (1 - std::sqrt(1 - kRadius * kRadius / (out * out))) / 2;
        // Cells on the horizon, an eighth of the sphere, see the ball or the wall by one ray each. Looking only at what
        // the probe sees along the direction itself, and from there once more, loses nearly all of the ball: 0.3 and
        // more.
        CHECK(std::abs(by_probes - exact) < 0.03);
    }
}

TEST_CASE("sight ends at polygons among the hair, alike on every instruction set") {
    const BeforeSquare s(true);
    const Vec3 at = Vec3(0.3f, -0.2f, 0.7f) - Vec3(s.scene.origin), beside = at + Vec3(0.05f, -0.03f, 0.04f);
    const LightProbe probe = s.probe(at);
    const Igloo igloo = make_igloo(64);
    const Viewpoint from{beside, frame_about(normalize(Vec3(1, 2, 3))), Dome::sphere};
    const uint32_t cells = igloo.cells_of(Dome::sphere);
    std::vector<float> first;
    for (const Isa isa : supported_isas()) {
        std::vector<float> sight;
        projection_kernels(isa).find_sight(probe, s.igloo(), igloo, from, sight);
        sight.resize(cells);
        if (first.empty()) first = sight;
        CHECK(sight == first);
    }
    const Bounds& hair = s.prepared.projection.bounds;
    for (uint32_t cell = 0; cell < cells; ++cell) {
        float farthest = 0, nearest = kInfinity;
        for (int i = 0; i < 400; ++i) {
            const Vec2 u((float(i / 20) + 0.5f) / 20, (float(i % 20) + 0.5f) / 20);
            const Vec3 direction = from.frame.to_world(direction_in(igloo, cell, u));
            const float distance = square_distance(beside, direction, s.scene.origin);
            const Vec3 seen = beside + distance * direction;
            const bool among =
                distance < kInfinity && min_component(seen - hair.lo) >= 0 && min_component(hair.hi - seen) >= 0;
            nearest = std::min(nearest, among ? distance : kInfinity);
            if (among) farthest = std::max(farthest, distance);
        }
        CAPTURE(cell);
        // The probe's rays are some of all that the cell sees, from a little aside.
        if (farthest == 0 && first[cell] < kInfinity) CHECK(std::sqrt(first[cell]) < 4);
        if (farthest > 0 && first[cell] < kInfinity) {
            CHECK(std::sqrt(first[cell]) > 0.9f * nearest);
            CHECK(std::sqrt(first[cell]) < 1.2f * farthest + length(beside - at));
        }
    }
}

TEST_CASE("probes are made only where projection has polygons to see") {
    CHECK(BeforeSquare(true).prepared.probes);
    Options options = small_options();
    options.type2 = GatherMethod::projection;
    const Scene bare = assemble({upright_fibers({Vec2(0)}, 1, 0.1f, white_fiber())}, {},
                                {EnvironmentLight{"", {}, Rgb(1), 0}}, camera_on_z(6, 40, 8));
    CHECK_FALSE(prepare(bare, make_plan(bare, options), options).probes);
}
