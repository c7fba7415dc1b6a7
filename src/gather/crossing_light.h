// SPDX-License-Identifier: MIT
// Light of Type 3 by the method `ray`: fibers that gather rays cross are lit by lamps, through hair, and reflect.
#pragma once

#include "gather/gather_rays.h"
#include "gather/visibility.h"

namespace tress {

class CrossingLight {
public:
    /// Adds to radiance[i] the light that points[i], where the rays start, sends to the eye. `lamps` are indices of
    /// lights.
    void operator()(const Scene& scene, const PreparedScene& prepared, const Options& options,
                    std::span<const uint32_t> lamps, const GatherRays& rays, std::span<Rgb> radiance);
};

}  // namespace tress
