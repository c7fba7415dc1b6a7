// SPDX-License-Identifier: MIT
// A few of the points that the eye sees: what views and constants are fitted to.
#pragma once

#include "gather/shading_point.h"

namespace tress {

struct SeenPoints {
    std::vector<ShadingPoint> hair, polygons;
};

/// From one camera ray at a hashed place in each cell of a grid of kSeenRays x kSeenRays over the picture; the same
/// whatever the number of threads.
inline constexpr int kSeenRays = 128;
SeenPoints find_seen_points(const Scene& scene, const PreparedScene& prepared, const Options& options);

}  // namespace tress
