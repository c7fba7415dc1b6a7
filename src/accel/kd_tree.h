// SPDX-License-Identifier: MIT
// A kd-tree as data: nodes and packed leaf blocks, in coordinates relative to `origin`. Built by build_segment_tree or
// build_triangle_tree (build.h), asked by queries.h.
#pragma once

#include <cstdint>
#include <vector>

#include "accel/kd_node.h"
#include "accel/leaf_blocks.h"
#include "core/bounds.h"

namespace tress {

/// What the builder makes, before leaf data is packed: leaf nodes name a run of `references` in place of blocks.
struct KdTopology {
    std::vector<KdNode> nodes;         // nodes[0] is the root; never empty
    std::vector<uint32_t> references;  // primitives, leaf after leaf, ascending in each
    Bounds bounds;                     // of everything, in the coordinates that the builder was given
};

struct KdTree {
    DVec3 origin{0};            // subtracted from coordinates before they were rounded to float
    Bounds bounds;              // relative to origin
    std::vector<KdNode> nodes;  // empty: nothing to hit
    LeafBlocks leaves;
    bool open_ends = false;     // segments: strands share their ends, so a crossing at a joint is counted once
    float longest_segment = 0;  // no axis is longer; 0: not known

    bool empty() const { return nodes.empty(); }
};

inline size_t bytes(const KdTree& tree) { return tree.nodes.capacity() * sizeof(KdNode) + bytes(tree.leaves); }

}  // namespace tress
