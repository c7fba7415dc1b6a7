// SPDX-License-Identifier: MIT
#include "gather/path_tracer.h"

#include <doctest/doctest.h>

#include "tests/path_support.h"
#include "tests/plain_path_tracer.h"

using namespace tress;
using namespace tress::test;

namespace {

constexpr uint32_t kBlonde = 0, kDark = 1;

/// Strands of a few segments, bent at random, within a ball about `center`.
PlacedHair ball_of_hair(int strands, int segments, double ball, float radius, const Vec3& center, uint64_t seed,
                        const Fiber& fiber) {
    PlacedHair hair;
    hair.fiber = fiber;
    hair.strands.constant_radius = radius;
    hair.strands.first = {0};
    for (int s = 0; s < strands; ++s) {
        const uint64_t key = hash(seed, uint64_t(s));
        uint64_t drawn = 0;
        const auto within = [&](double size) {
            Vec3 p;
            for (int axis = 0; axis < 3; ++axis) p[axis] = float(size * (2 * double(tress::random(key, drawn++)) - 1));
            return p;
        };
        Vec3 p = within(0.6 * ball);
        const Vec3 along = normalize(within(1)) * float(1.6 * ball / segments);
        p -= along * (0.5f * float(segments));
        for (int i = 0; i <= segments; ++i) {
            hair.strands.add_point(center + p);
            p += along + within(0.3 * ball / segments);
        }
        hair.strands.first.push_back(uint32_t(hair.strands.points()));
    }
    return hair;
}

Fiber fiber_with(const Rgb& sigma_a) {
    FiberParameters parameters;
    parameters.sigma_a = sigma_a;
    return make_fiber(parameters);
}

/// Blonde hair beside dark hair before a wall, over a floor, under every kind of light.
Scene two_tufts(int size) {
    PlacedMesh wall = square(4, {0.7f, 0.5f, 0.3f}), floor = square(4, Rgb(0.6f));
    wall.placement.m[11] = -2;
    floor.placement.m = {1, 0, 0, 0, 0, 0, 1, -1.4, 0, -1, 0, 0};  // facing +y
    EnvironmentLight sky;
    sky.radiance = {0.1f, 0.15f, 0.25f};
    const std::vector<Light> lights = {PointLight{{1, 3, 4}, Rgb(12)}, SpotLight{{-3, 2, 5}, {0, 0, 0}, 50, Rgb(20)},
                                       DistantLight{{0.2, -0.5, -1}, Rgb(0.5f)},
                                       QuadLight{{-1, 3, 1}, {{2, 0, 0}, {0, 0.5, 1}}, Rgb(2)}, sky};
    return assemble({ball_of_hair(120, 3, 0.7, 0.03f, {-0.8f, 0, 0}, 1, fiber_with(sigma_a_from_melanin(0.2f, 0.1f))),
                     ball_of_hair(120, 3, 0.7, 0.03f, {0.8f, 0, 0}, 2, fiber_with(sigma_a_from_melanin(4, 0.2f)))},
                    {wall, floor}, lights, camera_on_z(8, 32, size));
}

Mean trace_plainly(const Viewed& view, const std::vector<ShadingPoint>& points, size_t count, uint64_t seed) {
    const PlainPathTracer tracer(view.scene, view.prepared, view.options.scattering == ScatteringModel::full);
    Mean mean;
    for (size_t i = 0; i < count; ++i)
        mean.add(double(luminance(tracer.sample(points[i % points.size()], hash(seed, i)))));
    return mean;
}

}  // namespace

TEST_CASE("the five types together are what a plain path tracer finds without types") {
    const Scene scene = two_tufts(24);
    for (const ScatteringModel scattering : {ScatteringModel::straight, ScatteringModel::full}) {
        const Viewed view(scene, all_by_path(scattering));
        for (const uint32_t fiber : {kBlonde, kDark, kPolygon}) {
            const std::vector<ShadingPoint> points = view.points_on(fiber);
            REQUIRE(points.size() > 20);
            const TypeMeans types = trace_paths(view, points, 32768, 1);
            const Mean plain = trace_plainly(view, points, 32768, 2);
            const double error = standard_error_of_difference(types.sum, plain);
            MESSAGE(points.size() << " points: paths " << types.sum.value() << " +- " << types.sum.standard_error()
                                  << ", plainly " << plain.value() << " +- " << plain.standard_error() << " types "
                                  << types.type[0].value() << " " << types.type[1].value() << " "
                                  << types.type[2].value() << " " << types.type[3].value() << " "
                                  << types.type[4].value());
            CHECK(error < 0.01 * plain.value());
            CHECK(std::abs(types.sum.value() - plain.value()) < 3 * error);
        }
    }
}
