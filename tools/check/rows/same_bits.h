// SPDX-License-Identifier: MIT
// D41 and D42. Pictures that must not depend on how they are worked out.
#pragma once

#include "tools/check/check_row.h"

namespace tress {
Outcome measure_threads_and_passes(const CheckSettings& settings);
Outcome measure_instruction_sets(const CheckSettings& settings);
}  // namespace tress
