// SPDX-License-Identifier: MIT
// The sum of the five types against a plain path tracer, on whole heads of hair. The scene of straight.hair needs the
// folder that TRESS_DATA names.
#include <doctest/doctest.h>

#include <chrono>
#include <cstdlib>
#include <sstream>

#include "core/builtin_scene.h"
#include "io/load_scene.h"
#include "io/scene_file.h"
#include "tests/path_support.h"

using namespace tress;
using namespace tress::test;

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Means of light with their standard errors, and the types' shares of it.
std::string figures(const TypeMeans& types, const Mean& plain) {
    std::ostringstream text;
    text << "sum of types " << types.sum.value() << " +- " << types.sum.standard_error() << ", plainly "
         << plain.value() << " +- " << plain.standard_error() << ", difference " << types.sum.value() - plain.value()
         << " +- " << standard_error_of_difference(types.sum, plain) << "; types in percent";
    const double percent = 100 / types.sum.value();
    for (const Mean& type : types.type)
        text << " " << percent * type.value() << " +- " << percent * type.standard_error();
    return text.str();
}

/// What a small picture shows, hair and polygons apart.
void check_partition(const std::string& name, const SceneDescription& description, size_t samples, PlainSky sky) {
    constexpr size_t kPlainEach = 2;  // the plain way has more noise
    const Scene scene = load_scene(description).scene;
    for (const ScatteringModel scattering : {ScatteringModel::straight, ScatteringModel::full}) {
        const Viewed view(scene, all_by_path(scattering));
        for (const uint32_t fiber : {0u, kPolygon}) {
            const std::vector<ShadingPoint> points = view.points_on(fiber);
            REQUIRE(points.size() > 100);
            const auto start = std::chrono::steady_clock::now();
            const TypeMeans types = trace_paths(view, points, samples, 1);
            const double seconds = seconds_since(start);
            const Mean plain = trace_plainly(view, points, kPlainEach * samples, 2, sky);
            const std::string model = scattering == ScatteringModel::full ? "full" : "straight";
            const std::string kind = fiber == kPolygon ? "polygons" : "hair";
            MESSAGE(name << ", " << model << ", " << points.size() << " points of " << kind << ": "
                         << figures(types, plain) << "; " << double(samples) / seconds << " samples a second");
            const double error = standard_error_of_difference(types.sum, plain);
            CHECK(error < 0.02 * plain.value());  // reached on dark hair, whose light is least even
            CHECK(std::abs(types.sum.value() - plain.value()) < 3 * error);
        }
    }
}

SceneDescription with_melanin(SceneDescription description, const Melanin& melanin) {
    for (HairDescription& hair : description.hair) hair.fiber.absorption = melanin;
    description.camera.width = description.camera.height = 64;
    return description;
}

}  // namespace

TEST_SUITE("slow") {
    TEST_CASE("the five types make the whole of the light in the built-in scene, on dark and on blonde hair") {
        check_partition("built-in, dark", with_melanin(builtin_scene(), {4, 0.2f}), size_t(1) << 17, PlainSky::met);
        check_partition("built-in, blonde", with_melanin(builtin_scene(), {0.1f, 0.15f}), size_t(1) << 17,
                        PlainSky::met);
    }

    TEST_CASE("the five types make the whole of the light on straight.hair") {
        const char* data = std::getenv("TRESS_DATA");
        if (!data || !*data) {
            MESSAGE("skipped whole: TRESS_DATA does not name a folder of hair data");
            return;
        }
        SceneDescription scene = read_scene_file(std::string(TRESS_SOURCE_DIR) + "/scenes/straight.json");
        scene.camera.width = scene.camera.height = 64;
        check_partition("straight.hair", scene, size_t(1) << 19, PlainSky::asked);  // a small sun: more noise
    }
}
