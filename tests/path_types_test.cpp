// SPDX-License-Identifier: MIT
// Each type of light by itself: against closed forms, against other ways to it, and when it alone is asked for.
#include <doctest/doctest.h>

#include "gather/direct_light.h"
#include "tests/path_support.h"
#include "tools/check/support/tufts.h"

using namespace tress;
using namespace tress::test;

namespace {

constexpr float kRadius = 0.3f, kIrradiance = 3;
const Rgb kAbsorption(0.3f, 0.5f, 0.8f);

/// An upright fiber that the eye sees, one beside it, and a lamp far away: `second` is where the other stands (x, z),
/// `lamp` the unit vector towards the lamp.
Scene two_fibers(const Vec2& second, const Vec3& lamp) {
    const Fiber fiber = fiber_with(kAbsorption);
    Camera camera = camera_on_z(20, 1e-3, 1);
    camera.from.x = camera.to.x = 0.1;
    return assemble({upright_fibers({{0, 0}, second}, 100, kRadius, fiber)}, {},
                    {DistantLight{-DVec3(lamp), Rgb(kIrradiance)}}, camera);
}

/// The light that the first fiber sends to the eye after the second reflected it: the integral over all directions that
/// meet the second, by midpoints.
Rgb reflected_once(const Viewed& view, const Vec3& lamp) {
    constexpr int kInclinations = 2000, kAzimuths = 200;
    const ShadingPoint& x = view.points[0];
    const Fiber& fiber = view.scene.fibers[0];
    const Vec3 axis = view.prepared.segments.start(1), tangent(0, 1, 0);
    const DVec3 to_axis(axis.x - x.position.x, 0, axis.z - x.position.z);
    const double half = std::asin(double(kRadius) / length(to_axis)), middle = std::atan2(to_axis.x, -to_axis.z);
    glm::dvec3 sum(0);
    for (int i = 0; i < kInclinations; ++i) {
        const double inclination = double(kPi) * ((i + 0.5) / kInclinations - 0.5);
        for (int j = 0; j < kAzimuths; ++j) {
            const double azimuth = middle + half * (2 * (j + 0.5) / kAzimuths - 1);
            const DVec3 flat(std::sin(azimuth), 0, -std::cos(azimuth));
            const Vec3 w(std::cos(inclination) * flat + std::sin(inclination) * DVec3(tangent));
            const DVec3 offset = dot(to_axis, flat) * flat - to_axis;  // of the crossing from the axis
            const float h = float(dot(offset, normalize(cross(DVec3(w), DVec3(tangent)))) / double(kRadius));
            const Frame frame = fiber_frame(tangent, -w);
            const Rgb reflected = evaluate(fiber, kAbsorption, frame.to_local(-w), frame.to_local(lamp), h).reflected;
            sum += glm::dvec3(scatter(view.scene, x, w).value() * reflected) * std::cos(inclination);
        }
    }
    return Rgb(sum * (double(kIrradiance) * double(kPi) / kInclinations * 2 * half / kAzimuths));
}

}  // namespace

TEST_CASE("a lone lamp behind a fiber is weakened by it in type 1, and there is no type 2 and no type 5") {
    const Scene scene = two_fibers({0, -1}, {0, 0, -1});
    const Viewed view(scene, all_by_path());
    REQUIRE(view.points.size() == 1);
    const TypeMeans types = trace_paths(view, view.points, 1024, 1);
    const Rgb through = forward_albedo(scene.fibers[0], kAbsorption, 0);
    const Rgb unshadowed = scatter(scene, view.points[0], {0, 0, -1}).value() * kIrradiance;
    // One lamp, one ray, nothing random: what is left is rounding, and the table between its rows.
    CHECK(types.type[0].value() == doctest::Approx(double(luminance(unshadowed * through))).epsilon(1e-4));
    CHECK(types.type[0].standard_error() < 1e-6 * types.type[0].value());
    CHECK(types.type[1].sum == 0);
    CHECK(types.type[4].sum == 0);
}

TEST_CASE("type 3 between two fibers is the integral over all directions that meet the second") {
    const Vec3 lamp(-0.8f, 0, 0.6f);
    const Scene scene = two_fibers({0, -1}, lamp);
    Options options = all_by_path();
    options.type4 = ScatteredMethod::off;
    const Viewed view(scene, options);
    REQUIRE(view.points.size() == 1);
    const Mean type3 = trace_paths(view, view.points, size_t(1) << 17, 1).type[2];
    const double expected = double(luminance(reflected_once(view, lamp)));
    MESSAGE("type 3 " << type3.value() << " +- " << type3.standard_error() << ", by quadrature " << expected);
    CHECK(type3.standard_error() < 0.02 * expected);
    CHECK(std::abs(type3.value() - expected) < 3 * type3.standard_error());
}

TEST_CASE("a type that alone is asked for is what it is among all of them, and no other is booked") {
    // Ten comparisons, of light whose rare contributions are the brightest: errors are themselves known to a tenth.
    constexpr double kErrors = 4;
    constexpr size_t kSamples = 65536;
    const Scene scene = two_tufts(24);
    for (const ScatteringModel scattering : {ScatteringModel::straight, ScatteringModel::full}) {
        const Viewed all(scene, all_by_path(scattering));
        const std::vector<ShadingPoint> points = all.points_on(kBlonde);
        const TypeMeans together = trace_paths(all, points, kSamples, 3);
        for (int type = 0; type < kPathTypes; ++type) {
            CAPTURE(type + 1);
            Options options = all_by_path(scattering);
            for (int other = 0; other < kPathTypes; ++other)
                if (other != type) switch_off(options, PathType(other));
            const TypeMeans alone = trace_paths(Viewed(scene, options), points, kSamples, 4);
            const Mean &a = alone.type[size_t(type)], &b = together.type[size_t(type)];
            const double error = standard_error_of_difference(a, b);
            CAPTURE(a.value());
            CAPTURE(b.value());
            CHECK(std::abs(a.value() - b.value()) < kErrors * error);
            CHECK(alone.sum.value() == a.value());
        }
    }
}

TEST_CASE("types 1 and 2 without polygons are what shadow rays to lamps and sky find") {
    constexpr size_t kSamples = 32768;
    Scene scene = two_tufts(24);
    scene.mesh = {};
    const Viewed view(scene, all_by_path());
    const TypeMeans paths = trace_paths(view, view.points, kSamples, 1);
    for (int type = 0; type < 2; ++type) {
        CAPTURE(type + 1);
        std::vector<ShadingPoint> points;
        std::vector<Sampler> samplers;
        for (size_t i = 0; i < kSamples; ++i) {
            points.push_back(view.points[i % view.points.size()]);
            samplers.push_back({hash(2, i), 0});
        }
        std::vector<Rgb> light(kSamples, Rgb(0));
        DirectLight()(scene, view.prepared, view.options, type == 0 ? view.plan.lamps : view.plan.environments, nullptr,
                      points, samplers, light);
        Mean direct;
        for (const Rgb& one : light) direct.add(double(luminance(one)));
        const double error = standard_error_of_difference(paths.type[size_t(type)], direct);
        CHECK(error < 0.02 * direct.value());
        CHECK(std::abs(paths.type[size_t(type)].value() - direct.value()) < 3 * error);
    }
}
