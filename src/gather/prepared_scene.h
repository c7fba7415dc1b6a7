// SPDX-License-Identifier: MIT
// What is built once for a scene before its rays are traced: just what the plan lists.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "accel/kd_tree.h"
#include "core/attenuation.h"
#include "core/environment.h"
#include "core/photon_statistics.h"
#include "core/plan.h"
#include "core/scene.h"
#include "core/stage_cost.h"
#include "gather/photons/photon_maps.h"
#include "gather/projection/hair_projection.h"
#include "gather/projection/light_probes.h"
#include "gather/shadow_maps/lamp_maps.h"

namespace tress {

struct PreparedScene {
    SegmentView segments;                                        // of the scene's hair, which must outlive this
    KdTree hair, mesh;                                           // empty where left out
    Attenuation attenuation;                                     // empty where left out
    std::vector<std::optional<EnvironmentSampler>> environment;  // one a light; none where not an environment
    std::array<LampMaps, kMapKinds> shadow_maps;                 // by kind; empty where left out
    HairProjection projection;                                   // likewise
    std::unique_ptr<LightProbes> probes;                         // null where left out; made as points ask for them
    PhotonMaps photons;                                          // empty where left out
    PhotonStatistics photon_statistics;                          // likewise
    std::vector<StageCost> costs;
};

PreparedScene prepare(const Scene& scene, const Plan& plan, const Options& options);

}  // namespace tress
