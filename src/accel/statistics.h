// SPDX-License-Identifier: MIT
// Figures of a tree, gathered by a walk after the build.
#pragma once

#include <cstdint>

#include "accel/kd_tree.h"
#include "core/options.h"

namespace tress {

struct TreeStatistics {
    uint64_t nodes = 0, leaves = 0, empty_leaves = 0, references = 0, bytes = 0;
    uint32_t depth = 0;
    double references_per_primitive = 0, references_per_leaf = 0;  // of leaves that are not empty
    double sah_cost = 0;  // expected cost of a ray through the root's box, in tests of one primitive
};
TreeStatistics statistics(const KdTree& tree, uint64_t primitives, const AccelOptions& options);

}  // namespace tress
