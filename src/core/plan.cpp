// SPDX-License-Identifier: MIT
#include "core/plan.h"

#include <cstdio>

#include "core/error.h"
#include "core/light_reach.h"

namespace tress {
namespace {

std::string counted(size_t n, const char* what) { return std::to_string(n) + " " + what + (n == 1 ? "" : "s"); }

/// What the scene holds and the options ask for, in the words of the rules below.
struct Wanted {
    TypeSet by_ray{}, by_photons{}, by_path{};  // by_ray: by any method that goes light by light, maps and cells too

    bool on(PathType type) const {
        const int t = index_of(type);
        return by_ray[t] || by_photons[t] || by_path[t];
    }
};

Wanted wanted_types(const Options& o) {
    Wanted w;
    w.by_path = {o.type1 == LampMethod::path, o.type2 == GatherMethod::path, o.type3 == CrossingMethod::path};
    w.by_ray = {o.type1 != LampMethod::off && !w.by_path[0], o.type2 != GatherMethod::off && !w.by_path[1],
                o.type3 != CrossingMethod::off && !w.by_path[2]};
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

/// "type 3" or "types 2, 3".
std::string type_list(const TypeSet& types) {
    std::string text;
    for (size_t t = 0; t < types.size(); ++t)
        if (types[t]) text += (text.empty() ? "" : ", ") + std::to_string(t + 1);
    return (text.size() > 1 ? "types " : "type ") + text;
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
        list_shadow_maps();
        list_photons();
        list_projection();
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
    /// On, and the hair that light of the type needs on its way is there.
    bool may_be(PathType type) const {
        const bool scattered = type != PathType::type1 && type != PathType::type2;
        return on(type) && (plan_.hair_tree || !scattered);
    }
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
        const bool elsewhere = may_be(PathType::type2) || may_be(PathType::type5);
        if (environment) {
            if (elsewhere) return "";
            return on(PathType::type5) ? "type 2 is off, and there is no hair for type 5" : "types 2 and 5 are off";
        }
        const bool from_polygons = elsewhere && plan_.mesh_tree;
        if (may_be(PathType::type1) || may_be(PathType::type3) || may_be(PathType::type4) || from_polygons) return "";
        return "no type that is on takes light from lamps here";
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
        if (!may_be(type)) return "no hair to scatter light on its way";
        const bool from_lamps = type == PathType::type1 || type == PathType::type3 || type == PathType::type4;
        if (from_lamps && plan_.lamps.empty()) return "no lamp shines into the picture";
        if (wanted_.by_photons[index_of(type)] && options_.photons.count == 0) return kNoPhotons;
        if (from_lamps) return "";
        const bool map_alone = type == PathType::type2 && wanted_.by_ray[index_of(type)] && plan_.environments.empty();
        if (map_alone && plan_.mesh_tree && has_light() && options_.photons.count == 0) return kNoPhotons;
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

    void list_shadow_maps() {
        plan_.direct = by(wanted_.by_ray, PathType::type1);
        plan_.crossing_gather = by(wanted_.by_ray, PathType::type3);
        if (plan_.crossing_gather) plan_.crossing_maps = map_kind(options_.type3);
        if (plan_.direct && plan_.hair_tree) plan_.lamp_maps = lamp_maps();
        if (plan_.lamp_maps || plan_.crossing_maps) check_map_size();
        for (int kind = 0; kind < kMapKinds; ++kind) {
            TypeSet types{};
            types[index_of(PathType::type1)] = plan_.lamp_maps == MapKind(kind);
            types[index_of(PathType::type3)] = plan_.crossing_maps == MapKind(kind);
            decide(stage::kShadowMaps[kind], plan_.shadow_maps(MapKind(kind)),
                   counted(plan_.lamps.size(), "lamp") + ", for " + type_list(types), "no type asks for them");
        }
    }

    /// Throws InputError where maps would take more memory than a machine is likely to have.
    void check_map_size() const {
        double views = 0;
        for (const uint32_t lamp : plan_.lamps) views += double(view_count(scene_.lights[lamp], options_.maps.grid));
        const double texels = views * square(double(options_.maps.resolution));
        constexpr double kMost = double(1 << 26);
        if (texels > kMost)
            throw InputError("maps.resolution", std::to_string(options_.maps.resolution) + " for " +
                                                    counted(size_t(views), "view") + " of lamps, expected at most " +
                                                    std::to_string(int(std::sqrt(kMost / views))));
    }

    /// Needs crossing_maps.
    std::optional<MapKind> lamp_maps() {
        if (options_.type1 != LampMethod::automatic) return map_kind(options_.type1);
        plan_.lamp_cost = estimate_lamp_cost(scene_, options_, plan_.lamps);
        if (plan_.crossing_maps == MapKind::deep) plan_.lamp_cost->build = 0;  // made for type 3 all the same
        if (plan_.lamp_cost->maps_pay()) return MapKind::deep;
        return {};
    }

    /// ": an estimated 12 core seconds by rays, 3 by maps and 40 to make them"; empty: nothing was estimated.
    std::string estimate() const {
        if (!plan_.lamp_cost) return "";
        const LampCost& cost = *plan_.lamp_cost;
        char text[160];
        std::snprintf(text, sizeof text, ": an estimated %.1f core seconds by rays, %.1f by maps and %.1f to make them",
                      cost.rays, cost.maps, cost.build);
        return text;
    }

    /// "shadow rays" or the name of the maps.
    static std::string asked(const std::optional<MapKind>& maps) {
        return maps ? stage::kShadowMaps[int(*maps)] : "shadow rays";
    }

    /// Empty: type 2 reads it.
    std::string why_no_photon_map() const {
        if (!wanted_.by_ray[index_of(PathType::type2)]) return "no type reads it";
        if (!plan_.mesh_tree) return "no polygons";
        if (!has_light()) return "no light shines into the picture";
        return options_.photons.count == 0 ? kNoPhotons : "";
    }

    void list_photons() {
        for (const PathType type : {PathType::type4, PathType::type5})
            plan_.photon_display[size_t(index_of(type))] = by(wanted_.by_photons, type);
        const std::string why_no_map = why_no_photon_map();
        plan_.polygon_gather = why_no_map.empty();
        decide(stage::kPhotons, plan_.photons(), counted(size_t(options_.photons.count), "photon") + " from all lights",
               options_.photons.count == 0 ? kNoPhotons : "no type asks for them");
        decide(stage::kPhotonMap, plan_.polygon_gather, "type 2 reads the light of polygons from it", why_no_map);
        decide(stage::kShownPhotons, any(plan_.photon_display),
               "photons for " + type_list(plan_.photon_display) + " at the eye's points", "no type shows photons");
    }

    /// Empty: type 2 is by projection, if it is to be.
    std::string why_not_projected() const {
        const bool may_be = options_.type2 == GatherMethod::projection || options_.type2 == GatherMethod::automatic;
        if (!may_be) return "type 2 is not by projection";
        if (!plan_.types[index_of(PathType::type2)]) return why_dark(PathType::type2);
        if (!plan_.hair_tree) return "no hair";
        if (!plan_.sky && !plan_.polygon_gather) return "no light of type 2 comes through the hair";
        return "";
    }

    ProjectionDetail projection_detail() const {
        const ProjectionDetail asked = options_.projection.detail;
        if (asked != ProjectionDetail::automatic) return asked;
        return scene_.segments.point.size() > kMostProjected ? ProjectionDetail::tree : ProjectionDetail::all;
    }

    void list_projection() {
        plan_.sky = by(wanted_.by_ray, PathType::type2) && !plan_.environments.empty();
        std::string why_not = why_not_projected();
        const ProjectionDetail detail = projection_detail();
        if (why_not.empty()) {
            const GatherCost cost = estimate_gather_cost(
                scene_, options_, detail, plan_.sky ? plan_.environments.size() : 0, plan_.polygon_gather);
            if (options_.type2 == GatherMethod::automatic) plan_.gather_cost = cost;
            if (plan_.gather_cost && !cost.projection_pays()) why_not = "rays are faster" + gather_estimate();
            plan_.far_field = cost.far_field && why_not.empty();
            plan_.gap_points = why_not.empty() ? cost.gap_points : 0;
        }
        if (why_not.empty()) plan_.projection = detail;
        decide(stage::kProjectedHair, why_not.empty(), detail_reason(detail), why_not);
    }

    /// ": an estimated 12 core seconds by rays, 3 by projection and 2 to prepare it"; empty: nothing was estimated.
    std::string gather_estimate() const {
        if (!plan_.gather_cost) return "";
        const GatherCost& cost = *plan_.gather_cost;
        char text[160];
        std::snprintf(text, sizeof text,
                      ": an estimated %.1f core seconds by rays, %.1f by projection and %.1f to prepare it", cost.rays,
                      cost.projection, cost.build);
        return text;
    }

    static const char* detail_reason(ProjectionDetail detail) {
        switch (detail) {
            case ProjectionDetail::simplified:
                return "fewer strands, of fewer segments, as wide as what they stand for";
            case ProjectionDetail::layers:
                return "every segment; the farther, the fewer are projected";
            case ProjectionDetail::tree:
                return "moments in a tree of cubes, and the hair next to each point";
            default:
                return "every segment";
        }
    }

    void list_loop() {
        build(stage::kCameraRays, "the picture");
        for (int t = 0; t < kPathTypes; ++t) plan_.paths[t] = by(wanted_.by_path, PathType(t));

        if (plan_.direct)
            build(stage::kType1, counted(plan_.lamps.size(), "lamp") + ", by " + asked(plan_.lamp_maps) + estimate());
        if (plan_.projection)
            build(stage::kProjection, counted(size_t(options_.projection.cells), "cell") + " a hemisphere, " +
                                          counted(size_t(options_.projection.directions), "direction") +
                                          (plan_.mesh_tree ? "; polygons as probes between points see them" : "") +
                                          (plan_.far_field ? "; far hair as seen between points" : "") +
                                          gather_estimate());
        if (plan_.sky && !plan_.projection)
            build(stage::kSky, counted(plan_.environments.size(), "environment") + ", by shadow rays through the hair");
        if (plan_.gather_rays()) {
            TypeSet types{};
            types[index_of(PathType::type2)] = plan_.polygon_gather && !plan_.projection;
            types[index_of(PathType::type3)] = plan_.crossing_gather;
            build(stage::kGatherRays, counted(size_t(options_.gather.rays), "ray") +
                                          " a sample, drawn by the scattering, for " + type_list(types));
        }
        if (plan_.polygon_gather && !plan_.projection)
            build(stage::kPolygonGather, "the photon map at the end of gather rays, through the hair");
        if (plan_.crossing_gather)
            build(stage::kCrossingGather,
                  "lamps, at the fibers that gather rays cross, by " + asked(plan_.crossing_maps));
        if (any(plan_.photon_display))
            build(stage::kPhotonDisplay, type_list(plan_.photon_display) + ", by photons near by");
        if (any(plan_.paths)) build(stage::kPaths, type_list(plan_.paths) + ", by path tracing");
        for (int t = 0; t < kPathTypes; ++t)
            if (!plan_.types[t]) leave("type " + std::to_string(t + 1), why_dark(PathType(t)));
    }

    static constexpr const char* kNoPhotons = "photons.count is 0";
    static constexpr size_t kMostProjected = 50'000;  // segments; above, the tree is faster (docs/projection.md)

    const Scene& scene_;
    const Options& options_;
    const Wanted wanted_;
    Plan plan_;
};

}  // namespace

Plan make_plan(const Scene& scene, const Options& options) { return Planner(scene, options).make(); }

}  // namespace tress
