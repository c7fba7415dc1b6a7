// SPDX-License-Identifier: MIT
// Type 3 against the integral it stands for, crossing by crossing and direction by direction.
#include "gather/crossing_light.h"

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include "core/rng.h"
#include "gather/connection.h"
#include "tools/check/support/small_scenes.h"

using namespace tress;
using namespace tress::test;

namespace {

constexpr double kFloor = -2;  // z of the polygon

/// Fibers over a square, lamps that need no sampling: two before it, one below it that never shines in.
Scene fibers_over_square() {
    FiberParameters brown;
    brown.sigma_a = {0.05f, 0.15f, 0.4f};
    brown.beta_m = brown.beta_n = 0.8f;  // broad lobes: the quadrature below is coarse
    std::vector<Vec2> xz = {{0, 0}};     // and two rings about it, which rays cross where they have no gaps
    for (int i = 0; i < 7; ++i)
        for (const float radius : {1.0f, 1.6f}) {
            const float angle = 2 * kPi * (float(i) + 0.3f * radius) / 7;
            xz.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        }
    PlacedMesh floor = square(3, Rgb(0.6f, 0.5f, 0.3f));
    floor.placement.m[11] = kFloor;
    return assemble({upright_fibers(xz, 2, 0.3f, make_fiber(brown))}, {floor},
                    {PointLight{{1, 1.5, 3}, Rgb(20, 15, 10)}, DistantLight{{1, -0.3, -0.4}, Rgb(0.5f, 1, 2)},
                     PointLight{{0, 0, -5}, Rgb(1000)}},
                    camera_on_z(20, 15, 8));
}

struct Oracle {
    const Scene& scene;
    const PreparedScene& prepared;

    /// Product of a_k over crossings, up to a floor at t_far.
    Rgb through_hair(const RayBuffer& rays) const {
        Rgb left(1);
        const Crossings c = crossings(prepared.hair, rays.for_hair(), Isa::automatic);
        for (const uint32_t id : c.id) left *= attenuation(id, rays.direction(0));
        return left;
    }
    Rgb attenuation(uint32_t segment, const Vec3& direction) const {
        const Vec3 axis = normalize(prepared.segments.end(segment) - prepared.segments.start(segment));
        return exp(-prepared.attenuation.depth(segment, std::abs(dot(axis, direction))));
    }
    float to_floor(const Vec3& from, const Vec3& direction) const {
        const double z = kFloor - scene.origin.z, t = (z - double(from.z)) / double(direction.z);
        const DVec3 p = DVec3(from) + t * DVec3(direction) + scene.origin;
        return t > 1e-4 && std::abs(p.x) < 3 && std::abs(p.y) < 3 ? float(t) : kInfinity;
    }

    /// L_k: what a fiber reflects of all lamps.
    Rgb reflected(const ShadingPoint& point) const {
        Rgb sum(0);
        for (const Light& light : scene.lights) {
            const LightSample to = sample_lamp(light, point.position, Vec2(0));
            if (to_floor(point.position, to.direction) < to.distance) continue;
            RayBuffer ray;
            ray.add(point.position, to.direction, to.distance, point.excluded);
            sum += scatter(scene, point, to.direction).reflected * to.irradiance * through_hair(ray);
        }
        return sum;
    }

    /// sum_k V_{<k} L_k along a direction.
    Rgb along(const ShadingPoint& from, const Vec3& direction) const {
        RayBuffer ray;
        ray.add(from.position, direction, to_floor(from.position, direction), from.excluded);
        const Crossings c = crossings(prepared.hair, ray.for_hair(), Isa::automatic);
        Rgb sum(0), left(1);
        for (size_t k = 0; k < c.id.size(); ++k) {
            sum += left * reflected(fiber_point(scene, prepared, direction, {c.t[k], c.id[k], c.u[k], c.h[k]}));
            left *= attenuation(c.id[k], direction);
        }
        return sum;
    }

    /// Fibers stand upright: along y all is smooth, and round it they have bright rims less than a degree wide.
    DVec3 integral(const ShadingPoint& x) const {
        constexpr int rows = 40, columns = 4000;
        DVec3 sum(0);
        for (int i = 0; i < rows; ++i)
            for (int k = 0; k < columns; ++k) {
                const float y = 1 - 2 * (float(i) + 0.5f) / float(rows),
                            phi = 2 * kPi * (float(k) + 0.5f) / float(columns);
                const float radius = safe_sqrt(1 - y * y);
                const Vec3 wi(radius * std::cos(phi), y, radius * std::sin(phi));
                const Rgb weight = scatter(scene, x, wi).value();
                if (max_component(weight) > 0) sum += DVec3(weight * along(x, wi));
            }
        return sum * (4 * double(kPi) / (double(rows) * columns));
    }
};

struct Estimate {
    DVec3 mean{0}, error{0};
};

/// Of many copies of a point, each with numbers of its own.
Estimate estimate(const Scene& scene, const PreparedScene& prepared, const ShadingPoint& x,
                  std::span<const uint32_t> lamps, int crossings, size_t count) {
    Options options = small_options();
    options.gather.rays = 1024;
    options.gather.crossings = crossings;
    const std::vector<ShadingPoint> points(count, x);
    std::vector<Sampler> samplers;
    for (size_t i = 0; i < count; ++i) samplers.push_back({hash(41, i), uint32_t(i % 5)});
    GatherRays rays;
    make_gather_rays(scene, prepared, options, points, samplers, rays);
    std::vector<Rgb> radiance(count, Rgb(0));
    CrossingLight light;
    light(scene, prepared, options, lamps, nullptr, rays, radiance);
    Estimate e;
    DVec3 squares(0);
    for (const Rgb& r : radiance) e.mean += DVec3(r) / double(count), squares += DVec3(r) * DVec3(r) / double(count);
    for (int c = 0; c < 3; ++c) e.error[c] = std::sqrt(std::max(squares[c] - square(e.mean[c]), 0.0) / double(count));
    return e;
}

constexpr uint32_t kLamps[] = {0, 1, 2};

}  // namespace

TEST_CASE("Type 3 is its integral over directions and crossings, on a fiber and on a polygon, however many are drawn") {
    const Scene scene = fibers_over_square();
    const PreparedScene prepared = prepare(scene, make_plan(scene, {}), {});
    const Oracle oracle{scene, prepared};
    const Vec3 eye = normalize(Vec3(0.1f, 0.3f, -1));
    const ShadingPoint on_fiber = fiber_point(scene, prepared, eye, {10, 0, 0.5f, 0.4f});
    const ShadingPoint on_polygon = polygon_point(scene, eye, {10, 0, 0.05f, 0.533f});
    for (const ShadingPoint& x : {on_fiber, on_polygon}) {
        const DVec3 expected = oracle.integral(x);
        CAPTURE(x.fiber);
        CHECK(min_component(Vec3(expected)) > 0);
        for (const int crossings : {1, 3, 0}) {
            const Estimate e = estimate(scene, prepared, x, kLamps, crossings, 256);
            CAPTURE(crossings);
            for (int c = 0; c < 3; ++c) {
                CAPTURE(c);
                // 1 %: rows of 2.9 degrees, and 0.09 degrees across rims; twice as many of either move it by half of
                // that.
                CHECK(std::abs(e.mean[c] - expected[c]) < 4 * e.error[c] + 0.01 * expected[c]);
                CHECK(e.error[c] < 0.04 * expected[c]);
            }
        }
    }
}

TEST_CASE("without lamps, or without other hair, there is no Type 3") {
    const Scene scene = fibers_over_square();
    const PreparedScene prepared = prepare(scene, make_plan(scene, {}), {});
    const ShadingPoint x = fiber_point(scene, prepared, {0, 0, -1}, {10, 0, 0.5f, 0.4f});
    CHECK(estimate(scene, prepared, x, {}, 1, 100).mean == DVec3(0));
    const uint32_t below[] = {2};
    CHECK(estimate(scene, prepared, x, below, 0, 100).mean == DVec3(0));

    const Scene lone = assemble({upright_fibers({{0, 0}}, 2, 0.2f, white_fiber())}, {}, {PointLight{{1, 1, 3}, Rgb(9)}},
                                camera_on_z(20, 15, 8));
    const PreparedScene lone_prepared = prepare(lone, make_plan(lone, {}), {});
    const ShadingPoint y = fiber_point(lone, lone_prepared, {0, 0, -1}, {10, 0, 0.5f, 0.4f});
    const uint32_t lamp[] = {0};
    CHECK(estimate(lone, lone_prepared, y, lamp, 1, 100).mean == DVec3(0));

    const Scene bald = assemble({}, {square(1, Rgb(0.5f))}, {PointLight{{1, 1, 3}, Rgb(9)}}, camera_on_z(20, 15, 8));
    CHECK(render(bald, small_options()).layer("type3") == nullptr);
}

TEST_CASE("Type 3 is the same bit for bit for any number of threads and on every instruction set") {
    for (const int crossings : {2, 0}) {
        Options options = small_options();
        options.type1 = LampMethod::off;
        options.type2 = GatherMethod::off;
        options.gather.rays = 2;
        options.gather.crossings = crossings;
        options.spp = 4;
        const Scene scene = fibers_over_square();
        const Rendered usual = render(scene, options);
        const auto& expected = usual.layer("type3")->data;
        CHECK(*std::max_element(expected.begin(), expected.end()) > 0);
        for (const size_t threads : {size_t(1), size_t(3)}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            CHECK(render(scene, options).layer("type3")->data == expected);
        }
        for (const Isa isa : supported_isas()) {
            options.isa = isa;
            CHECK(render(scene, options).layer("type3")->data == expected);
        }
    }
}

TEST_CASE("lamps of absurd strength leave Type 3 finite") {
    Options options = small_options();
    options.spp = 2;
    for (const Light& light : {Light(PointLight{{0.3, 0, 0.5}, Rgb(1e30f)}), Light(PointLight{{0.6, 0, 0.7}, Rgb(1)}),
                               Light(QuadLight{{-1, -1, 2}, {{0, 2, 0}, {2, 0, 0}}, Rgb(1e30f)})}) {
        Scene scene = fibers_over_square();
        scene.lights = {light};
        const Rendered r = render(scene, options);
        for (const float v : r.layer("type3")->data) CHECK(std::isfinite(v));
    }
}
