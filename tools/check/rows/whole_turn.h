// SPDX-License-Identifier: MIT
// D47. The same scene, turned as a whole.
#pragma once

#include "tools/check/check_row.h"

namespace tress {
Outcome measure_turned_scene(const CheckSettings& settings);
}
