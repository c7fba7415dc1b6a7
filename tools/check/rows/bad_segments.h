// SPDX-License-Identifier: MIT
// D1, D2 and D4. Segments that cannot be rendered, or hardly.
#pragma once

#include "tools/check/check_row.h"

namespace tress {
Outcome measure_no_length(const CheckSettings& settings);
Outcome measure_hardly_any_length(const CheckSettings& settings);
Outcome measure_not_finite(const CheckSettings& settings);
}  // namespace tress
