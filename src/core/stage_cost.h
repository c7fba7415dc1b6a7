// SPDX-License-Identifier: MIT
// What a stage of a render cost: a row of --stats.
#pragma once

#include <cstddef>
#include <string>

namespace tress {

struct StageCost {
    std::string name;    // as the plan names it
    double seconds = 0;  // wall; stages that run side by side within the pixel loop share its wall time by work done
    size_t bytes = 0;    // kept after the stage
};

}  // namespace tress
