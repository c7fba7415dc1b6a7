// SPDX-License-Identifier: MIT
// D46. The same hair, its strands in another order or from tip to root.
#pragma once

#include "tools/check/check_row.h"

namespace tress {
Outcome measure_order_of_strands(const CheckSettings& settings);
}
