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
    // Expected for a ray through the root's box that nothing stops: inner nodes and references that it meets, and what
    // these cost, in tests of one primitive, at the options' traversal cost.
    double sah_steps = 0, sah_tests = 0, sah_cost = 0;
};
TreeStatistics statistics(const KdTree& tree, uint64_t primitives, const AccelOptions& options);

}  // namespace tress
