// SPDX-License-Identifier: MIT
// Fibers at the limits of what they may be: no bending, grazing light, no absorption and nothing but it.
#pragma once

#include "tools/check/check_rows.h"

namespace tress {

std::vector<CheckRow> fiber_limit_rows();  // D28 to D30

}  // namespace tress
