// SPDX-License-Identifier: MIT
#include "tools/info.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/bounds.h"
#include "core/error.h"
#include "core/segments.h"
#include "io/exr_file.h"
#include "io/file_name.h"
#include "io/load_scene.h"
#include "io/mesh_file.h"
#include "io/scene_file.h"
#include "io/strand_file.h"

namespace tress {
namespace {

using Json = nlohmann::ordered_json;

Json numbers(const DVec3& v) { return {v.x, v.y, v.z}; }

Json corners(const DBounds& box) {
    if (box.empty()) return nullptr;
    return {numbers(box.lo), numbers(box.hi)};
}

Json radius_range(const StrandSet& strands) {
    if (strands.radius.empty() && strands.constant_radius == 0) return nullptr;
    if (strands.radius.empty()) return {strands.constant_radius, strands.constant_radius};
    const auto [lowest, highest] = std::minmax_element(strands.radius.begin(), strands.radius.end());
    return {*lowest, *highest};
}

/// Box of what is finite.
template <class Points>
DBounds point_bounds(const Points& points, size_t count, const DVec3& origin) {
    DBounds box;
    for (size_t i = 0; i < count; ++i)
        if (const Vec3 p = points(i); is_finite(p)) box.add(DVec3(p) + origin);
    return box;
}

Json strand_counts(const StrandSet& strands, const SegmentList& segments) {
    return {{"strands", strands.strands()},
            {"points", strands.points()},
            {"segments", segments.point.size()},
            {"dropped_segments", segments.dropped}};
}

Json hair_info(const std::string& path) {
    const StrandData data = read_strand_file(path);
    const StrandSet& strands = data.strands;
    StrandSet traced = strands;  // without a radius there would be no segments to count
    if (traced.radius.empty() && traced.constant_radius == 0) traced.constant_radius = kDefaultRadius;
    Json info = {{"kind", "hair"}};
    info.update(strand_counts(traced, list_segments(traced)));
    info["dropped_strands"] = data.dropped_strands;
    info["triangles"] = 0;
    info["bounds"] = corners(point_bounds([&](size_t i) { return strands.point(i); }, strands.points(), DVec3(0)));
    info["radius"] = radius_range(strands);
    info["has_colors"] = !strands.color.empty();
    info["bytes"] = bytes(strands);
    return info;
}

Json mesh_info(const std::string& path) {
    const TriangleMesh mesh = read_mesh_file(path);
    return {{"kind", "mesh"},
            {"strands", 0},
            {"points", 0},
            {"segments", 0},
            {"vertices", mesh.vertices()},
            {"triangles", mesh.triangles()},
            {"bounds", corners(point_bounds([&](size_t i) { return mesh.vertex(i); }, mesh.vertices(), DVec3(0)))},
            {"radius", nullptr},
            {"has_normals", !mesh.normal.empty()},
            {"bytes", bytes(mesh)}};
}

Json scene_info(const std::string& path) {
    const LoadedScene loaded = load_scene(read_scene_file(path));
    const Scene& scene = loaded.scene;
    DBounds box = point_bounds([&](size_t i) { return scene.hair.point(i); }, scene.hair.points(), scene.origin);
    const DBounds meshes =
        point_bounds([&](size_t i) { return scene.mesh.vertex(i); }, scene.mesh.vertices(), scene.origin);
    if (!meshes.empty()) box.add(meshes);
    Json info = {{"kind", "scene"}};
    info.update(strand_counts(scene.hair, scene.segments));
    info["dropped_strands"] = loaded.report.dropped_strands;
    info["triangles"] = scene.mesh.triangles();
    info["bounds"] = corners(box);
    info["radius"] = radius_range(scene.hair);
    info["has_colors"] = !scene.sigma_a.empty();
    info["fibers"] = scene.fibers.size();
    info["surfaces"] = scene.albedo.size();
    info["lights"] = scene.lights.size();
    info["size"] = {scene.camera.width, scene.camera.height};
    info["bytes"] = bytes(scene.hair) + bytes(scene.mesh);
    return info;
}

Json picture_info(const std::string& path) {
    const LayeredImage image = read_exr(path);
    Json info = {{"kind", "picture"}, {"size", {image.width, image.height}}};
    Json layers = Json::array(), metadata = Json::object();
    for (const Layer& layer : image.layers) layers.push_back({{"name", layer.name}, {"channels", layer.channels}});
    for (const auto& [name, text] : image.metadata) metadata[name] = text;
    info["layers"] = layers;
    info["metadata"] = metadata;
    return info;
}

Json file_info(const std::string& path) {
    const std::string ending = file_ending(path);
    if (ending == ".json") return scene_info(path);
    if (ending == ".exr") return picture_info(path);
    if (is_mesh_file_name(path)) return mesh_info(path);
    if (is_strand_file_name(path)) return hair_info(path);
    throw InputError(path, "unknown kind of file, expected .json, .hair, .data, .tfx, .obj, .ply or .exr");
}

/// One line a fact.
void print(const Json& info, std::ostream& out) {
    for (const auto& [name, value] : info.items()) {
        std::string words = name;
        std::replace(words.begin(), words.end(), '_', ' ');
        out << words << std::string(words.size() < 18 ? 18 - words.size() : 1, ' ')
            << (value.is_string() ? value.get<std::string>()
                : value.is_null() ? "none"
                                  : value.dump(-1, ' ', false, Json::error_handler_t::replace))
            << '\n';
    }
}

struct InfoArguments {
    std::string file;
    bool json = false;
};

}  // namespace

void add_info_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("info", "Say what a scene, hair, mesh or picture file holds");
    const auto arguments = std::make_shared<InfoArguments>();
    command->add_option("file", arguments->file, "scene (.json), hair (.hair .data .tfx), mesh (.obj .ply) or .exr")
        ->required();
    command->add_flag("--json", arguments->json, "for programs");
    command->callback([arguments] {
        const Json info = file_info(arguments->file);
        if (arguments->json)
            std::cout << info.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
        else
            print(info, std::cout);
    });
}

}  // namespace tress
