// SPDX-License-Identifier: MIT
// D43. Hair files that lie or are damaged.
#pragma once

#include "tools/check/check_row.h"

namespace tress {
Outcome measure_corrupt_hair(const CheckSettings& settings);
}
