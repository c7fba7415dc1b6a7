// SPDX-License-Identifier: MIT
// D37. Photons too few, or too near each other.
#pragma once

#include "tools/check/check_row.h"

namespace tress {
Outcome measure_few_photons(const CheckSettings& settings);
}
