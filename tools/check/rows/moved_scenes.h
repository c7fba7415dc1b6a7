// SPDX-License-Identifier: MIT
// D5 and D7. The same scene far from the origin, and at other sizes.
#pragma once

#include "tools/check/check_row.h"

namespace tress {
Outcome measure_far_from_origin(const CheckSettings& settings);
Outcome measure_sizes(const CheckSettings& settings);
}  // namespace tress
