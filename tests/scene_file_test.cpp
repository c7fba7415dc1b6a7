// SPDX-License-Identifier: MIT
#include "io/scene_file.h"

#include <clocale>
#include <cstdlib>

#include "tests/io_support.h"

using namespace tress;
using namespace tress::test;

namespace {

std::string scene_message(const Folder& folder, const std::string& text) {
    const std::string path = write_bytes(folder.file("scene.json"), text);
    return message_of([&] { read_scene_file(path); });
}

SceneDescription scene_of(const Folder& folder, const std::string& text) {
    return read_scene_file(write_bytes(folder.file("scene.json"), text));
}

const char* const kFullScene = R"({
  "camera": {"from": [0, 20, 60.5], "to": [0, 10, 0], "up": [0, 0, 1], "fov": 25, "size": [640, 480]},
  "hair": [
    {"file": "a.hair", "matrix": [2, 0, 0, 1, 0, 2, 0, 2, 0, 0, 2, 3], "radius": 0.004, "radius_scale": 1.5,
     "children": {"count": 8, "spread": 0.3},
     "fiber": {"model": "marschner", "eumelanin": 0.5, "pheomelanin": 0.25, "beta_m": 0.2, "beta_n": 0.4, "alpha": 3,
               "eta": 1.5}},
    {"groom": "wavy", "segments": 2000, "fiber": {"sigma_a": [0.1, 0.2, 0.3]}},
    {"file": "/b.tfx", "fiber": {"color": [0.5, 0.4, 0.3]}},
    {"file": "c.data"}],
  "meshes": [
    {"file": "head.obj", "albedo": [0.8, 0.7, 0.6]},
    {"quad": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]},
    {"sphere": {"center": [1, 2, 3], "radius": 9}}],
  "lights": [
    {"type": "point", "position": [1, 2, 3], "intensity": [4, 5, 6]},
    {"type": "spot", "position": [1, 2, 3], "to": [0, 0, 0], "angle": 40, "intensity": [1, 1, 1]},
    {"type": "distant", "direction": [0, -1, 0], "irradiance": [3, 2, 1]},
    {"type": "quad", "corner": [0, 9, 0], "edges": [[1, 0, 0], [0, 0, 2]], "radiance": [7, 8, 9]},
    {"type": "environment", "file": "sky.exr", "radiance": [0.5, 0.5, 0.5], "rotation": -90}],
  "options": {"type2": "off", "spp": 16, "seed": 18446744073709551615, "cutoff": 1e-4,
              "accel": {"bins": 16, "clip": false}, "film": {"exposure": -1.5}}
})";

/// A scene with one hair object whose other keys are `keys`.
std::string with_hair(const std::string& keys) { return R"({"hair": [{"groom": "wavy", )" + keys + "}]}"; }
std::string with_light(const std::string& light) {
    return R"({"hair": [{"groom": "wavy"}], "lights": [)" + light + "]}";
}

}  // namespace

TEST_CASE("every key of a scene file arrives where it belongs") {
    const Folder folder;
    const SceneDescription scene = scene_of(folder, kFullScene);
    CHECK(scene.camera.from == DVec3(0, 20, 60.5));
    CHECK(scene.camera.up == DVec3(0, 0, 1));
    CHECK(scene.camera.fov == 25);
    CHECK(scene.camera.width == 640);
    CHECK(scene.camera.height == 480);

    REQUIRE(scene.hair.size() == 4);
    const HairDescription& hair = scene.hair[0];
    CHECK(hair.file == folder.file("a.hair"));
    CHECK(hair.placement.point({1, 1, 1}) == DVec3(3, 4, 5));
    CHECK(hair.radius == 0.004f);
    CHECK(hair.radius_scale == 1.5f);
    CHECK(hair.children.count == 8);
    CHECK(hair.children.spread == 0.3);
    CHECK(hair.fiber.parameters.model == FiberModel::marschner);
    CHECK(hair.fiber.parameters.beta_m == 0.2f);
    CHECK(hair.fiber.parameters.beta_n == 0.4f);
    CHECK(hair.fiber.parameters.alpha_degrees == 3);
    CHECK(hair.fiber.parameters.eta == 1.5f);
    CHECK(std::get<Melanin>(hair.fiber.absorption).pheomelanin == 0.25f);
    CHECK(scene.hair[1].groom == "wavy");
    CHECK(scene.hair[1].segments == 2000);
    CHECK_FALSE(scene.hair[1].radius);
    CHECK(std::get<SigmaA>(scene.hair[1].fiber.absorption).value == Rgb(0.1f, 0.2f, 0.3f));
    CHECK(scene.hair[2].file == "/b.tfx");
    CHECK(std::get<FiberColor>(scene.hair[2].fiber.absorption).value.x == 0.5f);
    CHECK(std::holds_alternative<std::monostate>(scene.hair[3].fiber.absorption));

    REQUIRE(scene.meshes.size() == 3);
    CHECK(std::get<std::string>(scene.meshes[0].shape) == folder.file("head.obj"));
    CHECK(scene.meshes[0].albedo == Rgb(0.8f, 0.7f, 0.6f));
    CHECK(std::get<QuadShape>(scene.meshes[1].shape).corner[2] == DVec3(1, 1, 0));
    CHECK(std::get<SphereShape>(scene.meshes[2].shape).radius == 9);

    REQUIRE(scene.lights.size() == 5);
    CHECK(std::get<PointLight>(scene.lights[0]).intensity == Rgb(4, 5, 6));
    CHECK(std::get<SpotLight>(scene.lights[1]).angle == 40);
    CHECK(std::get<DistantLight>(scene.lights[2]).irradiance == Rgb(3, 2, 1));
    CHECK(std::get<QuadLight>(scene.lights[3]).edge[1] == DVec3(0, 0, 2));
    const auto& sky = std::get<EnvironmentLight>(scene.lights[4]);
    CHECK(sky.file == folder.file("sky.exr"));
    CHECK(sky.rotation == -90);

    CHECK(scene.options.type2 == GatherMethod::off);
    CHECK(scene.options.spp == 16);
    CHECK(scene.options.seed == ~uint64_t(0));
    CHECK(scene.options.cutoff == 1e-4f);
    CHECK(scene.options.accel.bins == 16);
    CHECK_FALSE(scene.options.accel.clip);
    CHECK(scene.options.film.exposure == -1.5f);
}

TEST_CASE("an unknown key is named with its place and the nearest known one") {
    const Folder folder;
    const std::pair<std::string, std::string> bad[] = {
        {with_hair(R"("fiber": {"bta_m": 0.3})"),
         "scene.json: hair[0].fiber.bta_m: unknown key, nearest known: 'beta_m'"},
        {R"({"hairs": []})", "scene.json: hairs: unknown key, nearest known: 'hair'"},
        {with_hair(R"("radios": 1)"), "hair[0].radios: unknown key, nearest known: 'radius'"},
        {R"({"meshes": [{"sphere": {"centre": [0, 0, 0]}}]})", "meshes[0].sphere.centre: unknown key"},
        {with_light(R"({"type": "point", "position": [0, 0, 0], "radiance": [1, 1, 1]})"),
         "lights[0].radiance: unknown key"},
        {with_light(R"({"type": "pont"})"), "lights[0].type: unknown 'pont', nearest known: 'point'"},
        {R"({"hair": [{"groom": "wavy"}], "options": {"accel": {"bin": 4}}})", "nearest known: 'accel.bins'"},
        {R"({"hair": [{"groom": "wavy"}], "options": {"ssp": 4}})",
         "options.ssp: unknown option 'ssp', nearest known: 'spp'"},
    };
    for (const auto& [text, part] : bad) {
        const std::string message = scene_message(folder, text);
        CAPTURE(message);
        CAPTURE(part);
        CHECK(is_one_line(message));
        CHECK(contains(message, part));
    }
}

TEST_CASE("a value that is not what it should be is named with its place and what was expected") {
    const Folder folder;
    const std::pair<std::string, std::string> bad[] = {
        {with_hair(R"("radius": "thin")"), "hair[0].radius: 'thin', expected a number from 0 to"},
        {with_hair(R"("radius": -1)"), "hair[0].radius: -1, expected a number from 0"},
        {with_hair(R"("radius": 1e31)"), "expected a number"},
        {with_hair(R"("segments": 0)"), "expected a whole number from 1"},
        {with_hair(R"("segments": 1.5)"), "1.5, expected a whole number"},
        {with_hair(R"("matrix": [1, 2])"), "hair[0].matrix: an array of 2, expected an array of 12"},
        {with_hair(R"("matrix": [1,0,0,0, 0,1,0,0, 0,0,0,0])"), "flattens"},
        {with_hair(R"("children": {"spread": 1})"), "hair[0].children: no count"},
        {with_hair(R"("fiber": {"sigma_a": [1, 1, 1], "color": [1, 1, 1]})"), "more than one of"},
        {with_hair(R"("fiber": {"pheomelanin": 1, "color": [1, 1, 1]})"), "more than one of"},
        {with_hair(R"("fiber": {"color": [1, 1, 2]})"), "hair[0].fiber.color[2]: 2, expected a number from 0 to 1"},
        {with_hair(R"("fiber": {"model": "pbrt"})"), "unknown 'pbrt'"},
        {with_hair(R"("fiber": null)"), "hair[0].fiber: null, expected an object"},
        {R"({"hair": [{"file": "a.hair", "groom": "wavy"}]})", "hair[0]: both file and groom"},
        {R"({"hair": [{}]})", "hair[0]: none of file and groom"},
        {R"({"hair": [{"file": "a.hair", "segments": 4}]})", "hair[0].segments"},
        {R"({"hair": {}})", "hair: an object, expected an array"},
        {R"({"meshes": [{"file": "a.obj", "quad": []}]})", "meshes[0]: both file and quad"},
        {R"({"meshes": [{"quad": [[0, 0, 0], [1, 0, 0], [1, 1, 0]]}]})", "an array of 3, expected an array of 4"},
        {R"({"meshes": [{"sphere": {"radius": 0}}]})", "meshes[0].sphere.radius: 0"},
        {R"({"meshes": [{"sphere": {}, "albedo": [1, 1, 1.5]}]})", "meshes[0].albedo[2]: 1.5"},
        {R"({"camera": {"size": [0, 10]}, "hair": [{"groom": "wavy"}]})", "camera.size[0]: 0"},
        {R"({"camera": {"from": [0, 0, 0], "to": [0, 0, 0]}, "hair": [{"groom": "wavy"}]})", "same point"},
        {R"({"camera": {"up": [0, 0, 0]}, "hair": [{"groom": "wavy"}]})", "direction of length 0"},
        {R"({"camera": {"fov": 180}, "hair": [{"groom": "wavy"}]})", "camera.fov: 180"},
        {with_light(R"({"position": [0, 0, 0]})"), "lights[0]: no type"},
        {with_light(R"({"type": "point"})"), "lights[0]: no position"},
        {with_light(R"({"type": "quad", "corner": [0, 0, 0], "edges": [[1, 0, 0]]})"), "lights[0].edges"},
        {R"({"hair": [{"groom": "wavy"}], "options": {"spp": 0}})", "options.spp: '0' for spp"},
        {R"({"hair": [{"groom": "wavy"}], "options": {"spp": [1]}})", "options.spp: not a value"},
        {"{}", "neither hair nor meshes"},
        {R"({"hair": [], "meshes": []})", "neither hair nor meshes"},
        {"[]", "expected an object"},
        {"7", "expected an object"},
    };
    for (const auto& [text, part] : bad) {
        const std::string message = scene_message(folder, text);
        CAPTURE(text);
        CAPTURE(message);
        CAPTURE(part);
        CHECK(is_one_line(message));
        CHECK(contains(message, part));
    }
}

TEST_CASE("what is no JSON is refused with line and column, in one line") {
    const Folder folder;
    const std::pair<std::string, std::string> bad[] = {
        {"{\n  \"hair\": [\n    }\n]}", "scene.json: line 3, column 5: no JSON"},
        {"{\"radius\": 1e999}", "line 1, column"},
        {"{\"a\": 1,}", "line 1, column 9"},
        {"{\"a\": NaN}", "line 1, column"},
        {"", "line 1, column 1"},
        {"{\"a\": \"\n\"}", "line"},
        {"{\"a\": 1, \"a\": 2}", "'a' stands twice"},
        {std::string(1000, 'x'), "line 1"},
        {"\"" + std::string(100000, 'x'), "line 1"},
        {std::string("{\"\xff\xfe\": 1}"), "line 1"},
    };
    for (const auto& [text, part] : bad) {
        const std::string message = scene_message(folder, text);
        CAPTURE(message);
        CAPTURE(part);
        CHECK(is_one_line(message));
        CHECK(contains(message, part));
    }
}

TEST_CASE("nesting of any depth is refused, not followed") {
    const Folder folder;
    for (const size_t depth : {65, 1000, 1000000}) {
        CAPTURE(depth);
        CHECK(contains(scene_message(folder, std::string(depth, '[')), "nested deeper than 64"));
    }
    std::string objects;
    for (int i = 0; i < 100000; ++i) objects += "{\"options\":";
    CHECK(contains(scene_message(folder, objects), "nested deeper than 64"));
}

TEST_CASE("names of files take variables from the environment") {
    const Folder folder;
    setenv("TRESS_TEST_FOLDER", "/some/where", 1);
    unsetenv("TRESS_TEST_NONE");
    const auto file = [](const std::string& name) { return R"({"hair": [{"file": ")" + name + "\"}]}"; };
    CHECK(scene_of(folder, file("${TRESS_TEST_FOLDER}/a.hair")).hair[0].file == "/some/where/a.hair");
    CHECK(scene_of(folder, file("b/../a$.hair")).hair[0].file == folder.file("b/../a$.hair"));
    CHECK(contains(scene_message(folder, file("${TRESS_TEST_NONE}/a.hair")),
                   "hair[0].file: ${TRESS_TEST_NONE} is not set"));
    CHECK(contains(scene_message(folder, file("${TRESS_TEST_FOLDER/a.hair")), "${ without }"));
    CHECK(contains(scene_message(folder, file("a\\u0000.hair")), "a zero byte"));
    CHECK(contains(scene_message(folder, file("")), "no name"));
}

TEST_CASE("numbers are the same where the locale has a decimal comma") {
    const Folder folder;
    const std::string old = std::setlocale(LC_ALL, nullptr);
    bool found = false;
    for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE", "fr_FR"})
        found |= std::setlocale(LC_ALL, name) != nullptr;
    if (!found) MESSAGE("no locale with a decimal comma here");
    const SceneDescription scene = scene_of(folder, kFullScene);
    const std::string message = scene_message(folder, with_hair(R"("radius": -1.5)"));
    std::setlocale(LC_ALL, old.c_str());
    CHECK(scene.camera.from.z == 60.5);
    CHECK(scene.options.film.exposure == -1.5f);
    CHECK(contains(message, "-1.5, expected"));
}

TEST_CASE("a scene that is missing or a folder is refused in one line") {
    const Folder folder;
    CHECK(is_one_line(message_of([&] { read_scene_file(folder.file("none.json")); })));
    CHECK(is_one_line(message_of([&] { read_scene_file(folder.path()); })));
}
