// SPDX-License-Identifier: MIT
// The reference: unidirectional path tracing with next-event estimation and multiple importance sampling; each
// contribution is booked to the type of its path. No photons, no limit of depth but roulette.
#pragma once

#include <span>
#include <vector>

#include "core/path_type.h"
#include "core/plan.h"
#include "core/sampler.h"
#include "gather/shading_point.h"
#include "gather/visibility.h"

namespace tress {

class PathTracer {
public:
    /// Adds to light[i], for the types in plan.paths, one sample of what points[i] sends to the eye.
    void operator()(const Scene& scene, const PreparedScene& prepared, const Plan& plan, const Options& options,
                    std::span<const ShadingPoint> points, std::span<const Sampler> samplers,
                    std::span<LightByType> light);
};

}  // namespace tress
