// SPDX-License-Identifier: MIT
// Light of Types 4 and 5 by the method `photons`: those stored in the hair and on polygons, shown directly (Moon &
// Marschner 2006; Zinke & Weber 2006).
#pragma once

#include <span>
#include <vector>

#include "core/path_type.h"
#include "gather/shading_point.h"

namespace tress {

class PhotonDisplay {
public:
    /// Adds to light[i], for the types in `shown`, what points[i] sends to the eye.
    void operator()(const Scene& scene, const PreparedScene& prepared, const Options& options, const TypeSet& shown,
                    std::span<const ShadingPoint> points, std::span<LightByType> light);
};

}  // namespace tress
