// SPDX-License-Identifier: MIT
// Points that the eye sees, and the light that they may receive through hair: what projection is tried on before a
// render.
#pragma once

#include <optional>
#include <vector>

#include "gather/projection/seen_light.h"

namespace tress {

struct LightTrial {
    ShadingPoint point;
    std::optional<LightProbe> probe;  // the point's own, or the one by which it sees far hair; none: no need
    std::vector<SeenLight> seen;
};

struct LightTrials {
    std::vector<LightTrial> at_hair, at_polygons;
};

/// Some points spread over the picture; of those on polygons, which are lit through cells. All that the plan lists but
/// the gap must be prepared.
LightTrials make_light_trials(const Scene& scene, const Plan& plan, const PreparedScene& prepared,
                              const Options& options);

}  // namespace tress
