// SPDX-License-Identifier: MIT
// D36. The tree of hair at the limits of its indices, and the bytes that it takes.
#pragma once

#include "tools/check/check_row.h"

namespace tress {
Outcome measure_index_limits(const CheckSettings& settings);
}
