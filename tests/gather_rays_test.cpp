// SPDX-License-Identifier: MIT
// Gather rays: drawn by the scattering, weighed by it, ended by polygons.
#include "gather/gather_rays.h"

#include <doctest/doctest.h>

#include "tools/check/support/fiber_quadrature.h"
#include "tools/check/support/small_scenes.h"

using namespace tress;
using namespace tress::test;

namespace {

/// Copies of one point, each with numbers of its own.
struct Points {
    std::vector<ShadingPoint> points;
    std::vector<Sampler> samplers;

    Points(const ShadingPoint& point, size_t count) : points(count, point) {
        for (size_t i = 0; i < count; ++i) samplers.push_back({hash(31, i), uint32_t(i % 3)});
    }
};

GatherRays gather(const Scene& scene, const PreparedScene& prepared, const Points& from, int rays) {
    Options options;
    options.gather.rays = rays;
    GatherRays g;
    make_gather_rays(scene, prepared, options, from.points, from.samplers, g);
    return g;
}

PreparedScene prepared_for(const Scene& scene) { return prepare(scene, make_plan(scene, {}), {}); }

ShadingPoint point_on_square(const Scene& scene) { return polygon_point(scene, {0, 0, -1}, {5, 0, 0.3f, 0.1f}); }

/// Mean of the sums of weights of a point, and its standard error.
struct MeanWeight {
    DVec3 mean{0}, error{0};
};
MeanWeight mean_weight(const GatherRays& g, size_t points) {
    std::vector<DVec3> sum(points, DVec3(0));
    for (size_t ray = 0; ray < g.size(); ++ray) sum[g.point[ray]] += DVec3(g.weight[ray]);
    MeanWeight m;
    DVec3 squares(0);
    for (const DVec3& s : sum) m.mean += s / double(points), squares += s * s / double(points);
    for (int c = 0; c < 3; ++c) m.error[c] = std::sqrt(std::max(squares[c] - square(m.mean[c]), 0.0) / double(points));
    return m;
}

}  // namespace

TEST_CASE("weights of a square's rays are its albedo, one ray or many") {
    const Rgb albedo(0.7f, 0.5f, 0.2f);
    const Scene scene = assemble({}, {square(1, albedo)}, {}, camera_on_z(10, 5, 4));
    const PreparedScene prepared = prepared_for(scene);
    for (const int rays : {1, 5}) {
        const GatherRays g = gather(scene, prepared, Points(point_on_square(scene), 200), rays);
        CHECK(g.size() >= size_t(200 * rays) - 2);  // one in 2^24 lies in the plane
        for (size_t ray = 0; ray < g.size(); ++ray) {
            CHECK(g.rays.direction(ray).z > 0);
            CHECK(g.t[ray] == kInfinity);
            CHECK(g.polygon[ray] == kNone);
            for (int c = 0; c < 3; ++c)
                CHECK(g.weight[ray][c] == doctest::Approx(double(albedo[c]) / rays).epsilon(1e-6));
        }
    }
}

TEST_CASE("no ray starts below a triangle whose shading normal leans over") {
    PlacedMesh leaning = square(1, Rgb(0.5f));
    leaning.mesh.normal.assign(4, normalize(Vec3(2, 0, 1)));
    const Scene scene = assemble({}, {leaning}, {}, camera_on_z(10, 5, 4));
    const GatherRays g = gather(scene, prepared_for(scene), Points(point_on_square(scene), 2000), 1);
    CHECK(g.size() < 1900);
    CHECK(g.size() > 1000);
    for (size_t ray = 0; ray < g.size(); ++ray) CHECK(g.rays.direction(ray).z > 0);
}

TEST_CASE("weights of a fiber's rays add up to its albedo") {
    for (const FiberModel model : {FiberModel::chiang, FiberModel::marschner})
        for (const Rgb& sigma_a : {Rgb(0), Rgb(0.1f, 0.5f, 2.0f)}) {
            FiberParameters parameters;
            parameters.model = model;
            parameters.sigma_a = sigma_a;
            const Scene scene =
                assemble({upright_fibers({{0, 0}}, 10, 1, make_fiber(parameters))}, {}, {}, camera_on_z(30, 8, 4));
            const PreparedScene prepared = prepared_for(scene);
            const ShadingPoint point =
                fiber_point(scene, prepared, normalize(Vec3(0.1f, 0.5f, -1)), {10, 0, 0.5f, 0.3f});
            const Points from(point, 4000);
            const GatherRays g = gather(scene, prepared, from, 4);
            const double theta = std::asin(double(point.wo.x));
            const double phi = std::atan2(double(point.wo.z), double(point.wo.y));
            const Albedo albedo = albedo_of(scene.fibers[0], sigma_a, theta, phi, 0.3);
            const MeanWeight m = mean_weight(g, from.points.size());
            CAPTURE(int(model));
            for (int c = 0; c < 3; ++c) {
                CAPTURE(c);
                const double whole = albedo.forward[c] + albedo.reflected[c];
                CHECK(std::abs(m.mean[c] - whole) < 4 * m.error[c] + 2e-3 * whole);  // 2e-3: the quadrature
                CHECK(m.error[c] < 0.01);
            }
            if (model == FiberModel::chiang && sigma_a == Rgb(0))
                for (const Rgb& w : g.weight) CHECK(w.x == doctest::Approx(0.25).epsilon(1e-4));
        }
}

TEST_CASE("a ray ends at the first polygon, and knows where on it") {
    PlacedMesh near = square(2, Rgb(0.5f)), far = square(20, Rgb(0.5f));
    near.placement.m[11] = -3;
    far.placement.m[11] = -8;
    const Scene scene =
        assemble({upright_fibers({{0, 0}}, 1, 0.1f, white_fiber())}, {near, far}, {}, camera_on_z(30, 8, 4));
    const PreparedScene prepared = prepared_for(scene);
    const ShadingPoint point = fiber_point(scene, prepared, {0, 0, -1}, {10, 0, 0.5f, 0.3f});
    const GatherRays g = gather(scene, prepared, Points(point, 4000), 1);
    size_t on_near = 0, on_far = 0;
    for (size_t ray = 0; ray < g.size(); ++ray) {
        const DVec3 o(g.rays.origin(ray)), d(g.rays.direction(ray));
        const auto meets = [&](double z, double half) {
            const DVec3 p = o + (z - o.z) / d.z * d;
            return d.z < 0 && std::abs(p.x) < half && std::abs(p.y) < half;
        };
        const bool meets_near = meets(-3, 2), meets_far = !meets_near && meets(-8, 20);
        on_near += meets_near, on_far += meets_far;
        CAPTURE(ray);
        CHECK(g.polygon[ray] == (meets_near ? g.polygon[ray] & 1 : meets_far ? 2 | (g.polygon[ray] & 1) : kNone));
        const double t = meets_near ? (-3 - o.z) / d.z : (-8 - o.z) / d.z;
        if (meets_near || meets_far)
            CHECK(double(g.t[ray]) == doctest::Approx(t).epsilon(1e-5));
        else
            CHECK(g.t[ray] == kInfinity);
        CHECK(g.rays.for_hair().t_far[ray] == g.t[ray]);
        if (g.polygon[ray] == kNone) continue;
        const auto corner = scene.mesh.triangle(g.polygon[ray]);
        const Vec3 on = corner[0] + g.u[ray] * (corner[1] - corner[0]) + g.v[ray] * (corner[2] - corner[0]);
        const Vec3 met = g.rays.origin(ray) + g.t[ray] * g.rays.direction(ray);
        CHECK(glm::length(on - met) < 1e-4f);  // some ulps of 20 units
    }
    CHECK(on_near > 100);
    CHECK(on_far > 100);
}

TEST_CASE("a point's rays do not depend on which other points stand beside it, nor do two rays share numbers") {
    const Scene scene =
        assemble({upright_fibers({{0, 0}}, 1, 0.1f, white_fiber())}, {square(1, Rgb(0.5f))}, {}, camera_on_z(30, 8, 4));
    const PreparedScene prepared = prepared_for(scene);
    const Points all(fiber_point(scene, prepared, {0, 0, -1}, {10, 0, 0.5f, 0.3f}), 50);
    const GatherRays together = gather(scene, prepared, all, 3);
    Points last = all;
    last.points.erase(last.points.begin(), last.points.begin() + 49);
    last.samplers.erase(last.samplers.begin(), last.samplers.begin() + 49);
    const GatherRays alone = gather(scene, prepared, last, 3);
    for (size_t ray = 0; ray < alone.size(); ++ray) {
        const size_t same = together.size() - alone.size() + ray;
        CHECK(together.rays.direction(same) == alone.rays.direction(ray));
        CHECK(together.weight[same] == alone.weight[ray]);
        CHECK(together.point[same] == 49);
    }
    for (size_t a = 0; a < together.size(); ++a)
        for (size_t b = 0; b < a; ++b) CHECK(together.rays.direction(a) != together.rays.direction(b));
}
