// SPDX-License-Identifier: MIT
// What a scene needs under given options, and what it does not. The renderer builds what the plan lists and nothing
// else, and its figures list the same names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/gather_cost.h"
#include "core/lamp_cost.h"
#include "core/options.h"
#include "core/path_type.h"
#include "core/scene.h"

namespace tress {

struct PlanItem {
    std::string name, why;
};

struct Plan {
    std::vector<PlanItem> stages, left_out;

    bool hair_tree = false;
    bool mesh_tree = false;
    bool attenuation = false;                   // the table of a_k: hair stands between something and a light
    bool hair_colors = false;                   // strands have absorptions of their own
    std::vector<uint32_t> lamps, environments;  // indices of lights that shine into the picture

    TypeSet types{};               // on, and some light may be theirs: they have layers
    bool background = false;       // environments are seen past everything
    bool direct = false;           // type 1: lamps, by shadow rays or maps
    bool sky = false;              // type 2: environments, by shadow rays or projection
    bool polygon_gather = false;   // type 2: polygons, by the photon map where gather rays end
    bool crossing_gather = false;  // type 3: gather rays are lit where they cross hair
    TypeSet photon_display{};      // types 4 and 5: photons shown directly
    TypeSet paths{};               // traced as paths

    std::optional<MapKind> lamp_maps, crossing_maps;  // that types 1 and 3 ask; none: shadow rays
    std::optional<LampCost> lamp_cost;                // by which type 1 was chosen, where it is auto

    std::optional<GatherCost> gather_cost;       // by which type 2 was chosen, where it is auto
    std::optional<ProjectionDetail> projection;  // type 2: what of the hair is projected; none: rays
    bool far_field = false;                      // points share far hair
    int gap_points = 0;                          // of hair, at which the gap is found

    bool gather_rays() const { return (polygon_gather && !projection) || crossing_gather; }
    bool shadow_maps(MapKind kind) const { return lamp_maps == kind || crossing_maps == kind; }
    bool photons() const { return polygon_gather || any(photon_display); }
};

/// Names of stages, shared by the plan and the figures.
namespace stage {
inline constexpr const char* kHairTree = "hair tree";
inline constexpr const char* kMeshTree = "mesh tree";
inline constexpr const char* kAttenuation = "attenuation table";
inline constexpr const char* kHairColors = "hair colours";
inline constexpr const char* kEnvironment = "environment table";
inline constexpr const char* kShadowMaps[kMapKinds] = {"deep shadow maps", "opacity shadow maps",
                                                       "clustered densities"};
inline constexpr const char* kProjectedHair = "projected hair";
inline constexpr const char* kPhotons = "photons";
inline constexpr const char* kPhotonMap = "photon map";
inline constexpr const char* kShownPhotons = "shown photons";
inline constexpr const char* kCameraRays = "camera rays";
inline constexpr const char* kType1 = "type 1";
inline constexpr const char* kSky = "type 2 from the sky";
inline constexpr const char* kProjection = "type 2 by projection";
inline constexpr const char* kGatherRays = "gather rays";
inline constexpr const char* kPolygonGather = "type 2 from polygons";
inline constexpr const char* kCrossingGather = "type 3";
inline constexpr const char* kPhotonDisplay = "photon display";
inline constexpr const char* kPaths = "paths";
}  // namespace stage

/// Throws InputError where options contradict each other.
Plan make_plan(const Scene& scene, const Options& options);

}  // namespace tress
