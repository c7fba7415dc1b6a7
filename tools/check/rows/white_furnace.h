// SPDX-License-Identifier: MIT
// D45. White hair under a white sky.
#pragma once

#include "tools/check/check_row.h"

namespace tress {
Outcome measure_white_furnace(const CheckSettings& settings);
}
