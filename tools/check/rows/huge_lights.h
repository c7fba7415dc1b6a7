// SPDX-License-Identifier: MIT
// D40. Lights of absurd strength or nearness.
#pragma once

#include "tools/check/check_row.h"

namespace tress {
Outcome measure_huge_lights(const CheckSettings& settings);
}
