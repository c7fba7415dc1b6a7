// SPDX-License-Identifier: MIT
// D8. Radii of 0, and below.
#pragma once

#include "tools/check/check_row.h"

namespace tress {
Outcome measure_radius_limits(const CheckSettings& settings);
}
