// SPDX-License-Identifier: MIT
// The search for a split by the method that the options name, and the rule that says when a node becomes a leaf.
#pragma once

#include <span>
#include <vector>

#include "accel/cost_model.h"
#include "accel/sweep_split.h"

namespace tress {

/// Work space of find_split, kept between calls.
struct SplitScratch {
    SortedFaces faces;
    std::vector<float> centers;
};

std::optional<Split> find_split(std::span<const Reference> references, const Bounds& cell, const AccelOptions& options,
                                SplitScratch& scratch);

/// A node that is still to be built.
struct PendingNode {
    Bounds cell;
    uint32_t levels_left;    // of splits below this node
    int failed_splits_left;  // splits dearer than a leaf still allowed on the path
    uint64_t budget;         // references that the leaves below may hold together
};

/// The root of a tree over `primitives`.
PendingNode root_node(const Bounds& bounds, size_t primitives, const AccelOptions& options);

/// Whether it is worth looking for a split at all.
bool may_split(const PendingNode& node, size_t references, const AccelOptions& options);

/// Whether the best split found is taken.
bool takes(const Split& split, const PendingNode& node, size_t references, const AccelOptions& options);

/// The two children of a node of `references`, which got left and right of them.
struct PendingPair {
    PendingNode left, right;
};
PendingPair children(const PendingNode& node, const Split& split, size_t references, size_t left, size_t right);

}  // namespace tress
