// SPDX-License-Identifier: MIT
#include "gather/paths/path_tracer.h"

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include "tests/path_support.h"
#include "tools/check/support/tufts.h"

using namespace tress;
using namespace tress::test;

TEST_CASE("the five types together are what a plain path tracer finds without types") {
    constexpr size_t kSamples = 32768;  // enough for standard errors of half a percent, 1.5 % on dark hair
    const Scene scene = two_tufts(24);
    for (const ScatteringModel scattering : {ScatteringModel::straight, ScatteringModel::full}) {
        const Viewed view(scene, all_by_path(scattering));
        for (const uint32_t fiber : {kBlonde, kDark, kPolygon}) {
            CAPTURE(fiber);
            const std::vector<ShadingPoint> points = view.points_on(fiber);
            REQUIRE(points.size() > 20);
            const TypeMeans types = trace_paths(view, points, kSamples, 1);
            const Mean plain = trace_plainly(view, points, kSamples, 2);
            const double error = standard_error_of_difference(types.sum, plain);
            MESSAGE("sum of types " << types.sum.value() << ", plainly " << plain.value() << ", standard error "
                                    << error);
            CHECK(error < 0.015 * plain.value());
            CHECK(std::abs(types.sum.value() - plain.value()) < 3 * error);
            for (const Mean& type : types.type) CHECK(type.value() > 0);
        }
    }
}

TEST_CASE("a ball of white hair under a white sky cannot be seen: its white furnace is 1") {
    constexpr size_t kSamples = 131072;
    const Scene scene = assemble({ball_of_hair(300, 5, 1, 0.02f, Vec3(0), 3, white_fiber())}, {}, {EnvironmentLight{}},
                                 camera_on_z(8, 20, 32));
    for (const ScatteringModel scattering : {ScatteringModel::straight, ScatteringModel::full}) {
        const Viewed view(scene, all_by_path(scattering));
        const TypeMeans types = trace_paths(view, view.points, kSamples, 1);
        const double error = types.sum.standard_error();
        const double first_three = types.type[0].value() + types.type[1].value() + types.type[2].value();
        const std::string model = scattering == ScatteringModel::full ? "full" : "straight";
        MESSAGE(model << ": " << types.sum.value() << " +- " << error << "; types 1 to 3 alone " << first_three);
        CHECK(error < 0.0033);
        CHECK(std::abs(types.sum.value() - 1) < 0.01);
    }
}

TEST_CASE("paths are the same bit for bit for any number of threads and every instruction set") {
    const Scene scene = two_tufts(40);
    for (const ScatteringModel scattering : {ScatteringModel::straight, ScatteringModel::full}) {
        Options options = all_by_path(scattering);
        options.spp = 2;
        const Rendered one = render(scene, options);
        const auto check_same = [&](const Rendered& other) {
            REQUIRE(other.picture.layers.size() == one.picture.layers.size());
            for (size_t i = 0; i < one.picture.layers.size(); ++i)
                CHECK(other.picture.layers[i].data == one.picture.layers[i].data);
        };
        for (const size_t threads : {size_t(1), size_t(2), size_t(3)}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            CAPTURE(threads);
            check_same(render(scene, options));
        }
        for (const Isa isa : supported_isas()) {
            options.isa = isa;
            CAPTURE(isa_name(isa));
            check_same(render(scene, options));
        }
    }
}

TEST_CASE("lamps inside hair, of huge power, or of no size leave paths finite") {
    Scene scene = two_tufts(16);
    const Vec3 in_hair = scene.hair.point(0);
    scene.lights = {
        PointLight{DVec3(in_hair), Rgb(1e30f)}, QuadLight{DVec3(in_hair) - 0.5, {{1, 0, 0}, {0, 1, 0}}, Rgb(1e30f)},
        QuadLight{{0, 2, 2}, {{1e-20, 0, 0}, {0, -1e-20, 0}}, Rgb(1)}, SpotLight{{0, 2, 2}, {0, 0, 0}, 1e-3, Rgb(1)},
        EnvironmentLight{.file = {}, .image = {}, .radiance = Rgb(1e30f), .rotation = 0}};
    for (const ScatteringModel scattering : {ScatteringModel::straight, ScatteringModel::full}) {
        const TypeMeans types =
            trace_paths(Viewed(scene, all_by_path(scattering)), Viewed(scene, all_by_path()).points, 8192, 1);
        for (const Mean& type : types.type) CHECK(std::isfinite(type.sum));
    }
}

TEST_CASE("paths in a closed room that loses no light come to an end") {
    std::vector<PlacedMesh> room;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            room.push_back(square(1, Rgb(1)));
            auto& m = room.back().placement.m;
            m = {};
            m[size_t(4 * axis + 3)] = side;
            m[size_t(4 * ((axis + 1) % 3))] = m[size_t(4 * ((axis + 2) % 3) + 1)] = 1;
            m[size_t(4 * axis + 2)] = 1;
        }
    const Scene scene = assemble({}, room, {PointLight{{0.1, 0.2, 0.3}, Rgb(1)}}, camera_on_z(0.9, 90, 8));
    const TypeMeans types = trace_paths(Viewed(scene, all_by_path()), Viewed(scene, all_by_path()).points, 1024, 1);
    CHECK(types.type[0].value() > 0);
    CHECK(types.type[1].value() > 20 * types.type[0].value());  // many bounces, each as bright as the last
    CHECK(std::isfinite(types.sum.sum));
}
