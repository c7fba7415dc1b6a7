// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/seen_hair.h"

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include <algorithm>

#include "gather/ray_buffer.h"
#include "tools/check/support/tufts.h"

using namespace tress;
using namespace tress::test;

TEST_CASE("points that the eye sees lie on hair that nothing hides, whatever the number of threads") {
    const Scene scene = two_tufts(64);
    const Options options = small_options();
    const PreparedScene prepared = prepare(scene, make_plan(scene, options), options);
    const auto find = [&](size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return find_seen_hair(scene, prepared, options);
    };
    const SeenHair seen = find(1);
    CHECK(seen.points == find(4).points);
    CHECK(seen.points.size() > 500);
    const Bounds box = bounds(prepared.segments);
    CHECK(seen.bounds.lo == box.lo);
    CHECK(seen.bounds.hi == box.hi);
    RayBuffer rays;
    for (const Vec3& p : seen.points) {
        double nearest = 1e30;
        for (uint32_t s = 0; s < prepared.segments.size(); ++s) {
            const DVec3 a(prepared.segments.start(s)), along = DVec3(prepared.segments.end(s)) - a;
            const double u = glm::clamp(dot(DVec3(p) - a, along) / dot(along, along), 0.0, 1.0);
            nearest = std::min(nearest, distance(DVec3(p), a + u * along));
        }
        CHECK(nearest <= 0.03 * 1.001);  // the radius of this hair
        // What lies before a point seen is less than a fiber thick.
        const Vec3 way = p - Vec3(scene.camera.from);
        rays.add(Vec3(scene.camera.from), normalize(way), glm::length(way) - 0.1f, {});
    }
    std::vector<float> t(rays.size(), kInfinity), u(rays.size()), h(rays.size());
    std::vector<uint32_t> id(rays.size(), kNone);
    nearest_segment(prepared.hair, rays.for_hair(), {t, id, u, h}, options.isa);
    // A point is of the hair's ribbon, and beside its ray at round ends: aimed anew, one ray in a hundred may graze
    // hair.
    CHECK(std::count(id.begin(), id.end(), kNone) >= std::ptrdiff_t(0.99 * double(id.size())));
}
