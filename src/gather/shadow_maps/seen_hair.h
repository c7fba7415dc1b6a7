// SPDX-License-Identifier: MIT
// Which hair the eye sees, roughly: what views from lamps are fitted to.
#pragma once

#include "gather/prepared_scene.h"
#include "gather/shadow_maps/fit_views.h"

namespace tress {

/// From the points of seen_points.h.
SeenHair find_seen_hair(const Scene& scene, const PreparedScene& prepared, const Options& options);

}  // namespace tress
