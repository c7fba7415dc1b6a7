// SPDX-License-Identifier: MIT
// D3, D24, D25 and D39. The tree of hair where much lies in one place, where sizes differ widely, and of a single hair.
#pragma once

#include "tools/check/check_row.h"

namespace tress {
Outcome measure_identical_segments(const CheckSettings& settings);
Outcome measure_one_long_segment(const CheckSettings& settings);
Outcome measure_series_of_sizes(const CheckSettings& settings);
Outcome measure_single_hair(const CheckSettings& settings);
}  // namespace tress
