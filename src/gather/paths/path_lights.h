// SPDX-License-Identifier: MIT
// Next-event estimation for paths. At the last vertex of each every light offers one direction; one of them is kept in
// proportion to the light that it would bring, and only its shadow ray is traced: resampled importance sampling
// (Talbot et al. 2005) over the sum of all lights. Lights that rays may also find by scattering carry the weight of
// multiple importance sampling.
#pragma once

#include <span>
#include <vector>

#include "gather/paths/path_walk.h"
#include "gather/visibility.h"

namespace tress {

class PathLights {
public:
    /// Adds to light[w.start] what comes straight from the lights to the last vertex of each walk w.
    void operator()(const PathContext& context, std::span<const PathWalk> walks, std::span<LightByType> light);

private:
    RayBuffer rays_;
    std::vector<uint32_t> start_of_ray_;
    std::vector<LightByType> unshadowed_;
    std::vector<Rgb> visibility_;
    VisibilityQuery query_;
};

}  // namespace tress
