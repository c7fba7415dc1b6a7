// SPDX-License-Identifier: MIT
// D44. A system that reads, writes and stops as one would not expect.
#pragma once

#include "tools/check/check_row.h"

namespace tress {
Outcome measure_hostile_system(const CheckSettings& settings);
}
