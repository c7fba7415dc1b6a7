// SPDX-License-Identifier: MIT
// What a scene needs under given options, and what it does not. The renderer builds what the plan lists and nothing
// else, and its figures list the same names.
#pragma once

#include <string>
#include <vector>

#include "core/options.h"
#include "core/scene.h"

namespace tress {

struct PlanItem {
    std::string name, why;
};

struct Plan {
    std::vector<PlanItem> stages, left_out;

    bool hair_tree = false;
    bool mesh_tree = false;
    bool attenuation = false;            // the table of a_k: hair stands between something and a light
    bool hair_colors = false;            // strands have absorptions of their own
    std::vector<uint32_t> type1_lights;  // indices of lights that shine into the picture, by the type they belong to
    std::vector<uint32_t> type2_lights;
};

/// Names of stages, shared by the plan and the figures.
namespace stage {
inline constexpr const char* kHairTree = "hair tree";
inline constexpr const char* kMeshTree = "mesh tree";
inline constexpr const char* kAttenuation = "attenuation table";
inline constexpr const char* kHairColors = "hair colours";
inline constexpr const char* kEnvironment = "environment table";
inline constexpr const char* kCameraRays = "camera rays";
inline constexpr const char* kType1 = "type 1";
inline constexpr const char* kType2 = "type 2";
}  // namespace stage

Plan make_plan(const Scene& scene, const Options& options);

/// Why no light of this kind and place can reach the scene; empty: it may.
std::string why_unseen(const Light& light, const Bounds& bounds);

/// "quad", "environment" …
const char* light_name(const Light& light);

}  // namespace tress
