// SPDX-License-Identifier: MIT
// D6, D9, D10, D22 and D23. Rays and segments that are hard on the tree of hair, against double precision.
#pragma once

#include "tools/check/check_row.h"

namespace tress {
Outcome measure_thin_hair_from_far(const CheckSettings& settings);
Outcome measure_steep_cones(const CheckSettings& settings);
Outcome measure_rays_along_the_axis(const CheckSettings& settings);
Outcome measure_hair_on_split_planes(const CheckSettings& settings);
Outcome measure_flat_hair(const CheckSettings& settings);
}  // namespace tress
