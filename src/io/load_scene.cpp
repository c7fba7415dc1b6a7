// SPDX-License-Identifier: MIT
#include "io/load_scene.h"

#include <limits>

#include "core/error.h"
#include "core/groom.h"
#include "core/head.h"
#include "core/rng.h"
#include "io/exr_file.h"
#include "io/mesh_file.h"
#include "io/shape_mesh.h"
#include "io/strand_file.h"

namespace tress {
namespace {

constexpr uint64_t kGroomKey = 0x67726f6f6d;  // hashed with an object's place: alike grooms are not the same hair
constexpr uint64_t kChildrenKey = 0x6368696c64;

/// Runs `make`; what it throws gets the place in the scene file in front.
template <class Make>
auto at_place(const SceneDescription& description, const std::string& place, Make&& make) {
    try {
        return make();
    } catch (const InputError& error) {
        const bool has_both = !description.path.empty() && !place.empty();
        const std::string where = description.path + (has_both ? ": " : "") + place;
        if (where.empty()) throw;
        throw InputError(where, error.what());
    }
}

FiberParameters with_absorption(const FiberDescription& description) {
    FiberParameters parameters = description.parameters;
    const auto& absorption = description.absorption;
    const Melanin* melanin = std::get_if<Melanin>(&absorption);
    if (const auto* sigma_a = std::get_if<SigmaA>(&absorption))
        parameters.sigma_a = sigma_a->value;
    else if (const auto* color = std::get_if<FiberColor>(&absorption))
        parameters.sigma_a = sigma_a_from_color(color->value, parameters.beta_n);
    else
        parameters.sigma_a = sigma_a_from_melanin(melanin ? melanin->eumelanin : Melanin().eumelanin,
                                                  melanin ? melanin->pheomelanin : Melanin().pheomelanin);
    return parameters;
}

void set_radii(const HairDescription& description, StrandSet& strands) {
    const bool has_own = !strands.radius.empty() || strands.constant_radius > 0;
    if (description.radius || !has_own) {
        strands.radius = {};
        strands.constant_radius =
            float(double(description.radius.value_or(kDefaultRadius)) / description.placement.scale());
    }
    strands.constant_radius *= description.radius_scale;
    for (float& radius : strands.radius) radius *= description.radius_scale;
}

void set_colors(const HairDescription& description, StrandSet& strands) {
    if (!std::holds_alternative<std::monostate>(description.fiber.absorption)) {
        strands.color = {};
        return;
    }
    for (size_t p = 0; p < strands.color.size(); ++p) {
        Rgb& color = strands.color[p];
        if (is_finite(color)) {
            color = clamp(color, Rgb(0), Rgb(1));
        } else {
            color = Rgb(0);
            strands.x[p] = std::numeric_limits<float>::quiet_NaN();  // so that its segments are dropped and counted
        }
    }
}

StrandSet guides(const SceneDescription& description, size_t index, const std::string& place, LoadReport& report) {
    const HairDescription& hair = description.hair[index];
    if (hair.file.empty())
        return at_place(description, place,
                        [&] { return make_groom(hair.groom, hair.segments, hash(kGroomKey, index)); });
    StrandData data = read_strand_file(hair.file);
    report.dropped_strands += data.dropped_strands;
    return std::move(data.strands);
}

PlacedHair load_hair(const SceneDescription& description, size_t index, LoadReport& report) {
    const HairDescription& hair = description.hair[index];
    const std::string place = "hair[" + std::to_string(index) + "]";
    const Fiber fiber = at_place(description, place, [&] { return make_fiber(with_absorption(hair.fiber)); });
    StrandSet strands = guides(description, index, place, report);
    set_colors(hair, strands);
    set_radii(hair, strands);
    if (hair.children.count > 1)
        strands = at_place(description, place, [&] {
            return grow_children(strands, hair.children.count, hair.children.spread / hair.placement.scale(),
                                 hash(kChildrenKey, index));
        });
    report.strands += strands.strands();
    report.points += strands.points();
    return {std::move(strands), hair.placement, fiber};
}

/// `placement` after a move by `offset`.
Placement moved_first(const DVec3& offset, Placement placement) {
    const DVec3 shift = placement.vector(offset);
    for (int axis = 0; axis < 3; ++axis) placement.m[size_t(4 * axis + 3)] += shift[axis];
    return placement;
}

PlacedMesh load_mesh(const MeshDescription& mesh) {
    if (const auto* quad = std::get_if<QuadShape>(&mesh.shape))
        return {quad_mesh(*quad), moved_first(quad->corner[0], mesh.placement), mesh.albedo};
    if (const auto* sphere = std::get_if<SphereShape>(&mesh.shape))
        return {sphere_mesh(sphere->radius), moved_first(sphere->center, mesh.placement), mesh.albedo};
    if (std::holds_alternative<HeadShape>(mesh.shape)) return {make_head(), mesh.placement, mesh.albedo};
    return {read_mesh_file(std::get<std::string>(mesh.shape)), mesh.placement, mesh.albedo};
}

std::vector<Light> load_lights(std::vector<Light> lights) {
    for (Light& light : lights)
        if (auto* environment = std::get_if<EnvironmentLight>(&light); environment && !environment->file.empty())
            environment->image = read_environment(environment->file);
    return lights;
}

}  // namespace

LoadedScene load_scene(const SceneDescription& description) {
    LoadedScene loaded;
    std::vector<PlacedHair> hair;
    for (size_t i = 0; i < description.hair.size(); ++i) hair.push_back(load_hair(description, i, loaded.report));
    std::vector<PlacedMesh> meshes;
    for (const MeshDescription& mesh : description.meshes) meshes.push_back(load_mesh(mesh));
    std::vector<Light> lights = load_lights(description.lights);
    loaded.scene = at_place(description, "", [&] {
        return assemble(std::move(hair), std::move(meshes), std::move(lights), description.camera);
    });
    return loaded;
}

}  // namespace tress
