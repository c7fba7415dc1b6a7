// SPDX-License-Identifier: MIT
// Pieces of a growing tree. Tasks build pieces of their own; `join` lays them into one array in the order of the tree,
// so the result does not depend on which thread built what.
#pragma once

#include <memory>
#include <vector>

#include "accel/kd_tree.h"

namespace tress {

/// A part of the tree built by one task. Node 0 is its root; indices count from the fragment's own start.
struct Fragment {
    std::vector<KdNode> nodes;
    std::vector<uint32_t> references;
};

/// An inner node with two subtrees, or, without them, a fragment.
struct Subtree {
    Fragment fragment;
    uint32_t axis = 0;
    float split = 0;
    std::unique_ptr<Subtree> left, right;
};

/// Throws InputError where there are more nodes or references than nodes can name, or more nodes than `index_limit`.
KdTopology join(const Subtree& root, const Bounds& bounds, uint32_t index_limit);

}  // namespace tress
