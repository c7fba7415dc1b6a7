// SPDX-License-Identifier: MIT
#include "io/scene_file.h"

#include <algorithm>
#include <filesystem>

#include "core/error.h"
#include "io/file_name.h"
#include "io/json_fields.h"
#include "io/read_fiber.h"

namespace tress {
namespace {

constexpr long long kLargestSide = 1 << 16;         // pixels
constexpr long long kMostSegments = 1ll << 31;      // of a groom
constexpr long long kMostChildren = 100000;         // a guide
constexpr double kNarrowest = 1e-3, kWidest = 179;  // degrees, of a camera's field of view or a spot's cone
constexpr double kSmallest = 1e-30;                 // of what must be over 0

std::string file_name(const JsonValue& value, const std::string& folder) {
    return resolved_file_name(value.where(), value.text(), folder);
}

Camera read_camera(const JsonValue& object) {
    object.check_keys({"from", "to", "up", "fov", "size"});
    Camera camera;
    get(object, "from", camera.from);
    get(object, "to", camera.to);
    if (const auto up = object.find("up")) camera.up = up->direction();
    get(object, "fov", camera.fov, kNarrowest, kWidest);
    if (const auto size = object.find("size")) {
        const std::vector<JsonValue> sides = size->elements(2);
        camera.width = int(sides[0].whole_number(1, kLargestSide));
        camera.height = int(sides[1].whole_number(1, kLargestSide));
    }
    if (camera.from == camera.to) object.fail("from and to are the same point, expected two");
    return camera;
}

Placement read_placement(const JsonValue& object) {
    Placement placement;
    const auto matrix = object.find("matrix");
    if (!matrix) return placement;
    const std::vector<JsonValue> numbers = matrix->elements(placement.m.size());
    for (size_t i = 0; i < numbers.size(); ++i) placement.m[i] = numbers[i].number();
    if (!(placement.scale() > 0))
        matrix->fail("a matrix that flattens everything, expected a determinant that is not 0");
    return placement;
}

Children read_children(const JsonValue& object) {
    object.check_keys({"count", "spread"});
    Children children;
    children.count = int(object.at("count").whole_number(0, kMostChildren));
    get(object, "spread", children.spread, 0, kLargestNumber);
    return children;
}

HairDescription read_hair(const JsonValue& object, const std::string& folder) {
    object.check_keys({"file", "groom", "segments", "matrix", "radius", "radius_scale", "children", "fiber"});
    HairDescription hair;
    if (object.only_one_of({"file", "groom"}) == "file") {
        hair.file = file_name(object.at("file"), folder);
        if (const auto segments = object.find("segments"))
            segments->fail("segments of a file, expected them with a groom only");
    } else {
        hair.groom = object.at("groom").text();
    }
    if (const auto segments = object.find("segments"))
        hair.segments = uint64_t(segments->whole_number(1, kMostSegments));
    hair.placement = read_placement(object);
    if (const auto radius = object.find("radius")) hair.radius = float(radius->number(0, kLargestNumber));
    get(object, "radius_scale", hair.radius_scale, 0, kLargestNumber);
    if (const auto children = object.find("children")) hair.children = read_children(*children);
    if (const auto fiber = object.find("fiber")) hair.fiber = read_fiber(*fiber, {});
    return hair;
}

QuadShape read_quad(const JsonValue& value) {
    const std::vector<JsonValue> corners = value.elements(4);
    QuadShape quad;
    for (size_t c = 0; c < corners.size(); ++c) quad.corner[c] = corners[c].vector();
    return quad;
}

SphereShape read_sphere(const JsonValue& object) {
    object.check_keys({"center", "radius"});
    SphereShape sphere;
    get(object, "center", sphere.center);
    get(object, "radius", sphere.radius, kSmallest, kLargestNumber);
    return sphere;
}

HeadShape read_head(const JsonValue& value) {
    if (value.node().kind != JsonNode::Kind::boolean || value.node().text != "true")
        value.fail("expected true: the head has no parameters");
    return {};
}

MeshDescription read_mesh(const JsonValue& object, const std::string& folder) {
    object.check_keys({"file", "quad", "sphere", "head", "matrix", "albedo"});
    MeshDescription mesh;
    const std::string kind = object.only_one_of({"file", "quad", "sphere", "head"});
    if (kind == "file") mesh.shape = file_name(object.at("file"), folder);
    if (kind == "quad") mesh.shape = read_quad(object.at("quad"));
    if (kind == "sphere") mesh.shape = read_sphere(object.at("sphere"));
    if (kind == "head") mesh.shape = read_head(object.at("head"));
    mesh.placement = read_placement(object);
    get(object, "albedo", mesh.albedo, 1);
    return mesh;
}

PointLight read_point_light(const JsonValue& object) {
    object.check_keys({"type", "position", "intensity"});
    PointLight light;
    light.position = object.at("position").vector();
    get(object, "intensity", light.intensity);
    return light;
}

SpotLight read_spot_light(const JsonValue& object) {
    object.check_keys({"type", "position", "to", "angle", "intensity"});
    SpotLight light;
    light.position = object.at("position").vector();
    light.to = object.at("to").vector();
    get(object, "angle", light.angle, kNarrowest, kWidest);
    get(object, "intensity", light.intensity);
    if (light.position == light.to) object.fail("position and to are the same point, expected two");
    return light;
}

DistantLight read_distant_light(const JsonValue& object) {
    object.check_keys({"type", "direction", "irradiance"});
    DistantLight light;
    light.direction = object.at("direction").direction();
    get(object, "irradiance", light.irradiance);
    return light;
}

QuadLight read_quad_light(const JsonValue& object) {
    object.check_keys({"type", "corner", "edges", "radiance"});
    QuadLight light;
    light.corner = object.at("corner").vector();
    const std::vector<JsonValue> edges = object.at("edges").elements(2);
    for (size_t e = 0; e < edges.size(); ++e) light.edge[e] = edges[e].direction();
    get(object, "radiance", light.radiance);
    return light;
}

EnvironmentLight read_environment_light(const JsonValue& object, const std::string& folder) {
    object.check_keys({"type", "file", "radiance", "rotation"});
    EnvironmentLight light;
    if (const auto file = object.find("file")) light.file = file_name(*file, folder);
    get(object, "radiance", light.radiance);
    get(object, "rotation", light.rotation, -kLargestNumber, kLargestNumber);
    return light;
}

Light read_light(const JsonValue& object, const std::string& folder) {
    object.check_keys({"type", "position", "to", "angle", "intensity", "direction", "irradiance", "corner", "edges",
                       "radiance", "file", "rotation"});
    switch (choice(object.at("type"), {"point", "spot", "distant", "quad", "environment"})) {
        case 0:
            return read_point_light(object);
        case 1:
            return read_spot_light(object);
        case 2:
            return read_distant_light(object);
        case 3:
            return read_quad_light(object);
        default:
            return read_environment_light(object, folder);
    }
}

/// Nested objects are flattened: {"accel": {"bins": 32}} sets "accel.bins". Names and ranges are the option list's.
void read_options(const JsonValue& object, const std::string& prefix, Options& options) {
    for (const JsonValue& value : object.members()) {
        const JsonNode::Kind kind = value.node().kind;
        if (kind == JsonNode::Kind::object)
            read_options(value, prefix + value.key() + ".", options);
        else if (kind == JsonNode::Kind::array || kind == JsonNode::Kind::null)
            value.fail("not a value, expected a number, a text, true or false");
        else
            set_option(options, value.where(), prefix + value.key(), value.node().text);
    }
}

}  // namespace

SceneDescription read_scene_file(const std::string& path) {
    const JsonNode tree = read_json_file(path);
    const JsonValue root(tree, path);
    root.check_keys({"camera", "hair", "meshes", "lights", "options"});
    const std::string folder = std::filesystem::path(path).parent_path().string();
    SceneDescription scene;
    scene.path = path;
    if (const auto camera = root.find("camera")) scene.camera = read_camera(*camera);
    if (const auto hair = root.find("hair"))
        for (const JsonValue& object : hair->elements()) scene.hair.push_back(read_hair(object, folder));
    if (const auto meshes = root.find("meshes"))
        for (const JsonValue& object : meshes->elements()) scene.meshes.push_back(read_mesh(object, folder));
    if (const auto lights = root.find("lights"))
        for (const JsonValue& object : lights->elements()) scene.lights.push_back(read_light(object, folder));
    if (const auto options = root.find("options")) read_options(*options, "", scene.options);
    if (scene.hair.empty() && scene.meshes.empty()) root.fail("neither hair nor meshes, expected some of either");
    return scene;
}

}  // namespace tress
