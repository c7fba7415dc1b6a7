// SPDX-License-Identifier: MIT
// Points of hair that the eye sees, and the light that they may receive: what projection is tried on before a render.
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

/// Some points spread over the picture. All that the plan lists but the gap must be prepared.
std::vector<LightTrial> make_light_trials(const Scene& scene, const Plan& plan, const PreparedScene& prepared,
                                          const Options& options);

}  // namespace tress
