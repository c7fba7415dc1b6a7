// SPDX-License-Identifier: MIT
// D38. Scenes that lack something.
#pragma once

#include "tools/check/check_row.h"

namespace tress {
Outcome measure_bare_scenes(const CheckSettings& settings);
}
