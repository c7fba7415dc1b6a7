// SPDX-License-Identifier: MIT
#include "core/plan.h"

#include <glm/trigonometric.hpp>

namespace tress {
namespace {

std::string counted(size_t n, const char* what) { return std::to_string(n) + " " + what + (n == 1 ? "" : "s"); }

struct EmissionOf {
    Rgb operator()(const PointLight& light) const { return light.intensity; }
    Rgb operator()(const SpotLight& light) const { return light.intensity; }
    Rgb operator()(const DistantLight& light) const { return light.irradiance; }
    Rgb operator()(const QuadLight& light) const { return light.radiance; }
    Rgb operator()(const EnvironmentLight& light) const {
        Rgb brightest = light.image.empty() ? Rgb(1) : Rgb(0);
        for (const Rgb& texel : light.image.pixel) brightest = max(brightest, texel);
        return brightest * light.radiance;
    }
};

struct ShapeUnseen {
    const Bounds& bounds;

    std::string operator()(const PointLight&) const { return ""; }
    std::string operator()(const DistantLight& light) const {
        return dot(light.direction, light.direction) > 0 ? "" : "it has no direction";
    }
    std::string operator()(const EnvironmentLight&) const { return ""; }

    /// Cone against the sphere about the scene's box: outside when the angle to the centre exceeds the cone's by more
    /// than the angle that the sphere spans.
    std::string operator()(const SpotLight& light) const {
        const DVec3 to_scene = DVec3(bounds.center()) - light.position, axis = light.to - light.position;
        const double radius = 0.5 * length(DVec3(bounds.extent())), d = length(to_scene);
        if (length(axis) == 0 || d <= radius) return "";
        const double angle = std::acos(glm::clamp(dot(to_scene, axis) / (d * length(axis)), -1.0, 1.0));
        return angle > 0.5 * glm::radians(light.angle) + std::asin(radius / d) ? "its cone misses everything" : "";
    }
    std::string operator()(const QuadLight& light) const {
        const DVec3 normal = cross(light.edge[0], light.edge[1]);
        if (dot(normal, normal) == 0) return "it has no area";
        const DVec3 center(bounds.center()), half = 0.5 * DVec3(bounds.extent());
        const double farthest = dot(center - light.corner, normal) + dot(half, abs(normal));
        return farthest <= 0 ? "everything is behind its shining side" : "";
    }
};

}  // namespace

const char* light_name(const Light& light) {
    constexpr const char* names[] = {"point", "spot", "distant", "quad", "environment"};
    static_assert(std::size(names) == std::variant_size_v<Light>);
    return names[light.index()];
}

std::string why_unseen(const Light& light, const Bounds& bounds) {
    if (max_component(std::visit(EmissionOf{}, light)) <= 0) return "it is black";
    return std::visit(ShapeUnseen{bounds}, light);
}

Plan make_plan(const Scene& scene, const Options& options) {
    Plan plan;
    const auto build = [&](const std::string& name, const std::string& why) { plan.stages.push_back({name, why}); };
    const auto leave = [&](const std::string& name, const std::string& why) { plan.left_out.push_back({name, why}); };

    const size_t segments = scene.segments.point.size(), triangles = scene.mesh.triangles();
    plan.hair_tree = segments > 0;
    plan.hair_tree ? build(stage::kHairTree, counted(segments, "segment") + " to trace")
                   : leave(stage::kHairTree, "no hair");
    plan.mesh_tree = triangles > 0;
    plan.mesh_tree ? build(stage::kMeshTree, counted(triangles, "triangle") + " to trace")
                   : leave(stage::kMeshTree, "no meshes");

    const bool type1 = options.type1 != Type1Method::off, type2 = options.type2 != Type2Method::off;
    std::vector<PlanItem> lights;
    for (uint32_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        const bool is_environment = std::holds_alternative<EnvironmentLight>(light);
        const std::string name = "light " + std::to_string(i) + " (" + light_name(light) + ")";
        const bool nothing_to_light = scene.bounds.empty() && !is_environment;  // the camera sees the sky all the same
        std::string why = nothing_to_light ? "there is nothing to light" : why_unseen(light, scene.bounds);
        if (is_environment && !type2) why = "type2 is off";
        if (!is_environment && !type1) why = "type1 is off";
        if (!why.empty()) {
            leave(name, why);
            continue;
        }
        (is_environment ? plan.type2_lights : plan.type1_lights).push_back(i);
        lights.push_back({name, is_environment ? "sampled for type 2" : "sampled for type 1"});
    }
    const bool lit = !lights.empty();

    plan.attenuation = plan.hair_tree && lit;
    plan.attenuation ? build(stage::kAttenuation, counted(scene.fibers.size(), "fiber") + " to see lights through")
                     : leave(stage::kAttenuation, plan.hair_tree ? "no light is sampled" : "no hair");
    plan.hair_colors = plan.attenuation && !scene.sigma_a.empty();
    plan.hair_colors ? build(stage::kHairColors, "strands have colours of their own")
                     : leave(stage::kHairColors,
                             plan.attenuation ? "every strand has its fiber's colour" : "no table asks for them");
    plan.type2_lights.empty()
        ? leave(stage::kEnvironment, type2 ? "no environment shines into the picture" : "type2 is off")
        : build(stage::kEnvironment, counted(plan.type2_lights.size(), "environment") + " to sample by brightness");
    build(stage::kCameraRays, "the picture");
    for (const PlanItem& light : lights) plan.stages.push_back(light);
    const auto type = [&](const char* name, bool on, const std::vector<uint32_t>& sampled, const char* what) {
        if (!on)
            leave(name, "off");
        else if (sampled.empty())
            leave(name, std::string("no ") + what + " shines into the picture");
        else
            build(name, counted(sampled.size(), what) + ", by shadow rays through the hair");
    };
    type(stage::kType1, type1, plan.type1_lights, "lamp");
    type(stage::kType2, type2, plan.type2_lights, "environment");
    for (const char* name : {"type 3", "type 4", "type 5"}) leave(name, "off");
    return plan;
}

}  // namespace tress
