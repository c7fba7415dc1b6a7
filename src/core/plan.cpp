// SPDX-License-Identifier: MIT
#include "core/plan.h"

#include <glm/trigonometric.hpp>

#include "core/error.h"

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

namespace {

/// What the scene holds and the options ask for, in the words of the rules below.
struct Wanted {
    TypeSet by_ray{}, by_photons{}, by_path{};

    bool on(PathType type) const {
        const int t = index_of(type);
        return by_ray[t] || by_photons[t] || by_path[t];
    }
};

Wanted wanted_types(const Options& o) {
    Wanted w;
    const GatherMethod gathered[] = {o.type1, o.type2, o.type3};
    for (int t = 0; t < 3; ++t) {
        w.by_ray[t] = gathered[t] == GatherMethod::ray;
        w.by_path[t] = gathered[t] == GatherMethod::path;
    }
    const ScatteredMethod scattered[] = {o.type4, o.type5};
    for (int t = 3; t < kPathTypes; ++t) {
        w.by_photons[t] = scattered[t - 3] == ScatteredMethod::photons;
        w.by_path[t] = scattered[t - 3] == ScatteredMethod::path;
    }
    if (o.scattering == ScatteringModel::full)
        for (int t = 0; t < kPathTypes; ++t)
            if (w.by_ray[t] || w.by_photons[t])
                throw InputError("scattering", "'full' with type" + std::to_string(t + 1) +
                                                   " by another method, expected every type 'path' or 'off'");
    return w;
}

std::string list_types(const TypeSet& types) {
    std::string text;
    for (int t = 0; t < kPathTypes; ++t)
        if (types[t]) text += (text.empty() ? "" : ", ") + std::to_string(t + 1);
    return text;
}

/// Fills a plan step by step; each step says why.
class Planner {
public:
    Planner(const Scene& scene, const Options& options)
        : scene_(scene), options_(options), wanted_(wanted_types(options)) {}

    Plan make() {
        list_trees();
        list_lights();
        list_types_with_light();
        list_attenuation();
        list_photons();
        list_loop();
        return std::move(plan_);
    }

private:
    void build(const std::string& name, const std::string& why) { plan_.stages.push_back({name, why}); }
    void leave(const std::string& name, const std::string& why) { plan_.left_out.push_back({name, why}); }
    void decide(const char* name, bool built, const std::string& why, const std::string& why_not) {
        built ? build(name, why) : leave(name, why_not);
    }
    bool on(PathType type) const { return wanted_.on(type); }
    bool has_light() const { return !plan_.lamps.empty() || !plan_.environments.empty(); }

    void list_trees() {
        const size_t segments = scene_.segments.point.size(), triangles = scene_.mesh.triangles();
        plan_.hair_tree = segments > 0;
        decide(stage::kHairTree, plan_.hair_tree, counted(segments, "segment") + " to trace", "no hair");
        plan_.mesh_tree = triangles > 0;
        decide(stage::kMeshTree, plan_.mesh_tree, counted(triangles, "triangle") + " to trace", "no meshes");
    }

    /// Empty: it shines into the picture.
    std::string why_not_lit_by(const Light& light) const {
        const bool environment = std::holds_alternative<EnvironmentLight>(light);
        if (scene_.bounds.empty() && !environment) return "there is nothing to light";  // a sky is seen all the same
        const std::string unseen = why_unseen(light, scene_.bounds);
        if (!unseen.empty()) return unseen;
        const bool elsewhere = on(PathType::type2) || on(PathType::type5);
        if (environment) return elsewhere ? "" : "types 2 and 5 are off";
        const bool from_polygons = elsewhere && plan_.mesh_tree;
        if (on(PathType::type1) || on(PathType::type3) || on(PathType::type4) || from_polygons) return "";
        return "no type that is on takes light from lamps";
    }

    void list_lights() {
        for (uint32_t i = 0; i < scene_.lights.size(); ++i) {
            const Light& light = scene_.lights[i];
            const std::string name = "light " + std::to_string(i) + " (" + light_name(light) + ")";
            const std::string why_not = why_not_lit_by(light);
            const bool environment = std::holds_alternative<EnvironmentLight>(light);
            if (why_not.empty()) (environment ? plan_.environments : plan_.lamps).push_back(i);
            decide(name.c_str(), why_not.empty(), "shines into the picture", why_not);
        }
        decide(stage::kEnvironment, !plan_.environments.empty(),
               counted(plan_.environments.size(), "environment") + " to sample by brightness",
               "no environment shines into the picture");
        plan_.background = on(PathType::type2) && !plan_.environments.empty();
    }

    /// Empty: some light of the type may reach the eye.
    std::string why_dark(PathType type) const {
        if (!on(type)) return "off";
        if (!plan_.hair_tree && !plan_.mesh_tree) return "there is nothing to light";
        const bool scattered = type != PathType::type1 && type != PathType::type2;
        if (scattered && !plan_.hair_tree) return "no hair to scatter light on its way";
        const bool from_lamps = type == PathType::type1 || type == PathType::type3 || type == PathType::type4;
        if (from_lamps) return plan_.lamps.empty() ? "no lamp shines into the picture" : "";
        if (!plan_.environments.empty() || (plan_.mesh_tree && has_light())) return "";
        return plan_.mesh_tree ? "no light shines into the picture" : "no polygons and no environment";
    }

    void list_types_with_light() {
        for (int t = 0; t < kPathTypes; ++t) plan_.types[t] = why_dark(PathType(t)).empty();
    }

    bool by(const TypeSet& method, PathType type) const {
        return method[index_of(type)] && plan_.types[index_of(type)];
    }

    void list_attenuation() {
        const bool lit = plan_.hair_tree && any(plan_.types);
        const bool seen_through = options_.scattering == ScatteringModel::straight;
        plan_.attenuation = lit && seen_through;
        decide(stage::kAttenuation, plan_.attenuation, counted(scene_.fibers.size(), "fiber") + " to see light through",
               !plan_.hair_tree ? "no hair"
               : lit            ? "scattering is full: no fiber is seen through"
                                : "no light is sampled");
        plan_.hair_colors = plan_.attenuation && !scene_.sigma_a.empty();
        decide(stage::kHairColors, plan_.hair_colors, "strands have colours of their own",
               plan_.attenuation ? "every strand has its fiber's colour" : "no table asks for them");
    }

    void list_photons() {
        const bool polygons = by(wanted_.by_ray, PathType::type2) && plan_.mesh_tree;
        const bool some = options_.photons.count > 0;
        for (const PathType type : {PathType::type4, PathType::type5})
            plan_.photon_display[index_of(type)] = some && by(wanted_.by_photons, type);
        plan_.polygon_gather = some && polygons;
        const bool shown = any(plan_.photon_display);
        const std::string none = some ? "no type asks for them" : "photons.count is 0";
        decide(stage::kPhotons, plan_.photons(), counted(size_t(options_.photons.count), "photon") + " from all lights",
               none);
        decide(stage::kPhotonMap, plan_.polygon_gather, "type 2 reads the light of polygons from it",
               !by(wanted_.by_ray, PathType::type2) ? "no type reads it"
               : !plan_.mesh_tree                   ? "no polygons: type 2 is the environment's"
                                                    : none);
        decide(stage::kShownPhotons, shown,
               "photons for types " + list_types(plan_.photon_display) + " at the eye's points",
               some ? "no type shows photons" : none);
    }

    void list_loop() {
        build(stage::kCameraRays, "the picture");
        plan_.direct = by(wanted_.by_ray, PathType::type1);
        plan_.sky = by(wanted_.by_ray, PathType::type2) && !plan_.environments.empty();
        plan_.crossing_gather = by(wanted_.by_ray, PathType::type3);
        for (int t = 0; t < kPathTypes; ++t) plan_.paths[t] = by(wanted_.by_path, PathType(t));

        if (plan_.direct)
            build(stage::kType1, counted(plan_.lamps.size(), "lamp") + ", by shadow rays through the hair");
        if (plan_.sky)
            build(stage::kSky, counted(plan_.environments.size(), "environment") + ", by shadow rays through the hair");
        if (plan_.gather_rays()) {
            TypeSet types{};
            types[index_of(PathType::type2)] = plan_.polygon_gather;
            types[index_of(PathType::type3)] = plan_.crossing_gather;
            build(stage::kGatherRays, counted(size_t(options_.gather.rays), "ray") +
                                          " a sample, drawn by the scattering, for types " + list_types(types));
        }
        if (plan_.polygon_gather)
            build(stage::kPolygonGather, "the photon map at the end of gather rays, through the hair");
        if (plan_.crossing_gather) build(stage::kCrossingGather, "lamps, at the fibers that gather rays cross");
        if (any(plan_.photon_display))
            build(stage::kPhotonDisplay, "types " + list_types(plan_.photon_display) + ", by photons near by");
        if (any(plan_.paths)) build(stage::kPaths, "types " + list_types(plan_.paths) + ", by path tracing");
        for (int t = 0; t < kPathTypes; ++t)
            if (!plan_.types[t]) leave("type " + std::to_string(t + 1), why_dark(PathType(t)));
    }

    const Scene& scene_;
    const Options& options_;
    const Wanted wanted_;
    Plan plan_;
};

}  // namespace

Plan make_plan(const Scene& scene, const Options& options) { return Planner(scene, options).make(); }

}  // namespace tress
