// SPDX-License-Identifier: MIT
// Rays of a render: where they start, where they go, and that nothing but the seed changes them.
#include "gather/tree_rays.h"

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include "tools/check/support/small_scenes.h"

using namespace tress;
using namespace tress::test;

namespace {

constexpr float kRadius = 0.05f;
const Vec3 kLamp(3, 6, 5);

/// 5 x 5 fibers before a wall; half a picture of hair.
Scene comb(const std::vector<Light>& lights, int size = 64) {
    std::vector<Vec2> xz;
    for (int i = 0; i < 25; ++i) xz.push_back({float(i % 5) - 2, float(i / 5) - 2});
    PlacedMesh wall = square(10, Rgb(0.5f));
    wall.placement.m[11] = -6;
    return assemble({upright_fibers(xz, 2, kRadius, white_fiber())}, {wall}, lights, camera_on_z(30, 12, size));
}

PointLight lamp() { return {DVec3(kLamp), Rgb(100)}; }

struct Sets {
    Scene scene;
    Plan plan;
    PreparedScene prepared;
    std::vector<TreeRays> sets;

    Sets(const Scene& of, size_t most, const Options& options = {}) : scene(of), plan(plan_tree_rays(scene)) {
        prepared = prepare(scene, plan, options);
        sets = make_tree_rays(scene, plan, prepared, options, most);
    }
    const RayBuffer& rays(size_t set) const { return sets[set].rays; }
    const RayBuffer& shadow() const { return rays(1); }
    const RayBuffer& gather() const { return rays(2); }
};

bool same(const RayBuffer& a, const RayBuffer& b) {
    const RayBatch p = a.for_hair(), q = b.for_hair();
    const auto equal = [](const auto& x, const auto& y) { return std::equal(x.begin(), x.end(), y.begin(), y.end()); };
    return equal(p.ox, q.ox) && equal(p.oy, q.oy) && equal(p.oz, q.oz) && equal(p.dx, q.dx) && equal(p.dy, q.dy) &&
           equal(p.dz, q.dz) && equal(p.t_near, q.t_near) && equal(p.t_far, q.t_far) &&
           equal(p.skip_first, q.skip_first) && equal(p.skip_last, q.skip_last);
}

void check_starts_on_hair(const Scene& scene, const RayBuffer& rays) {
    const SegmentView hair = view(scene.hair, scene.segments);
    const RayBatch batch = rays.for_hair();
    for (size_t ray = 0; ray < rays.size(); ++ray) {
        CAPTURE(ray);
        const Vec3 o = rays.origin(ray);
        REQUIRE(batch.skip_first[ray] <= batch.skip_last[ray]);
        REQUIRE(batch.skip_last[ray] < hair.size());
        const Vec3 axis = hair.start(batch.skip_first[ray]);
        CHECK(std::hypot(o.x - axis.x, o.z - axis.z) < 1.001f * kRadius);
        CHECK(std::abs(o.y) < 2.001f);
        CHECK(length(rays.direction(ray)) == doctest::Approx(1).epsilon(1e-5));
    }
}

}  // namespace

TEST_CASE("rays start at the camera, or on hair, and go where they should") {
    const Sets s(comb({lamp()}), 3000);
    REQUIRE(s.sets.size() == 3);
    CHECK(s.sets[0].name == "primary");
    CHECK(s.sets[1].name == "shadow");
    CHECK(s.sets[2].name == "gather");
    CHECK(s.rays(0).size() == 3000);
    const Vec3 eye(s.scene.camera.from);
    for (size_t ray = 0; ray < s.rays(0).size(); ++ray) {
        CHECK(s.rays(0).origin(ray) == eye);
        CHECK(s.rays(0).far(ray) == kInfinity);
    }
    CHECK(s.shadow().size() > 1000);
    CHECK(s.shadow().size() <= 3000);
    check_starts_on_hair(s.scene, s.shadow());
    for (size_t ray = 0; ray < s.shadow().size(); ++ray)
        CHECK(length(s.shadow().origin(ray) + s.shadow().far(ray) * s.shadow().direction(ray) - kLamp) < 1e-3f);
    CHECK(s.gather().size() > 1000);
    CHECK(s.gather().size() <= 3000);
    check_starts_on_hair(s.scene, s.gather());
    size_t to_wall = 0;
    for (size_t ray = 0; ray < s.gather().size(); ++ray) {
        const float far = s.gather().far(ray);
        to_wall += far < kInfinity;
        if (far < kInfinity) CHECK(s.gather().origin(ray).z + far * s.gather().direction(ray).z < -5.99f);
    }
    CHECK(to_wall > 100);
    CHECK(to_wall < s.gather().size() - 100);
}

TEST_CASE("the same rays for any number of threads, others for another seed") {
    const Scene scene = comb({lamp()});
    const Sets all(scene, 2000);
    Options options;
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    const Sets alone(scene, 2000, options);
    options.seed = 1;
    const Sets other(scene, 2000, options);
    for (size_t set = 0; set < 3; ++set) {
        CAPTURE(set);
        CHECK(same(all.rays(set), alone.rays(set)));
        CHECK_FALSE(same(all.rays(set), other.rays(set)));
    }
}

TEST_CASE("without light there are no shadow rays, without hair neither these nor gather rays") {
    const Sets dark(comb({}), 1000);
    CHECK(dark.rays(0).size() == 1000);
    CHECK(dark.shadow().size() == 0);
    CHECK(dark.gather().size() > 0);
    const Sets bald(assemble({}, {square(1, Rgb(0.5f))}, {lamp()}, camera_on_z(10, 5, 16)), 1000);
    CHECK(bald.rays(0).size() == 1000);
    CHECK(bald.shadow().size() == 0);
    CHECK(bald.gather().size() == 0);
    const Sets black(comb({PointLight{DVec3(kLamp), Rgb(0)}}), 1000);
    CHECK(black.shadow().size() == 0);
}

TEST_CASE("an environment is asked where there is no lamp") {
    EnvironmentLight sky;
    sky.radiance = Rgb(1);
    const Sets under_sky(comb({sky}), 1000);
    CHECK(under_sky.shadow().size() > 200);
    check_starts_on_hair(under_sky.scene, under_sky.shadow());
    for (size_t ray = 0; ray < under_sky.shadow().size(); ++ray) CHECK(under_sky.shadow().far(ray) == kInfinity);
    const Sets both(comb({sky, lamp()}), 1000);
    for (size_t ray = 0; ray < both.shadow().size(); ++ray) CHECK(both.shadow().far(ray) < kInfinity);
}

TEST_CASE("ways that polygons block are left out") {
    const Sets s(comb({PointLight{DVec3(0, 0, -20), Rgb(100)}}), 1000);  // behind the wall
    CHECK(s.shadow().size() == 0);
}

TEST_CASE("many lamps share the rays") {
    const Sets s(comb(std::vector<Light>(7, lamp())), 1000);
    CHECK(s.shadow().size() > 900);
    CHECK(s.shadow().size() <= 1000);
}

TEST_CASE("few rays are spread over a large picture") {
    const Sets s(comb({lamp()}, 700), 8000);
    CHECK(s.rays(0).size() == 8000);
    size_t quarter[4] = {};
    for (size_t ray = 0; ray < s.rays(0).size(); ++ray) {
        const Vec3 d = s.rays(0).direction(ray);
        ++quarter[(d.x > 0) + 2 * (d.y > 0)];
    }
    for (const size_t rays : quarter) CHECK(rays > 1000);
    CHECK(s.shadow().size() > 1000);
}
