// SPDX-License-Identifier: MIT
// What a tree may grow to. Some options make trees of hundreds of times the usual size: that is found out while a tree
// grows, before its leaf data is made.
#pragma once

#include <atomic>
#include <limits>
#include <span>
#include <string>

#include "accel/kd_node.h"
#include "accel/leaf_blocks.h"
#include "core/error.h"

namespace tress {

struct TreeLimits {
    uint32_t index = KdNode::kMaxIndex;                     // nodes, and blocks of leaf data
    uint64_t bytes = std::numeric_limits<uint64_t>::max();  // of nodes and leaf data
};

/// Bytes that a tree will have, summed by all tasks that grow it. Whether the limit is passed does not depend on their
/// order.
class GrowingBytes {
public:
    /// `rows`: of a block of leaf data.
    GrowingBytes(uint64_t limit, uint32_t rows) : limit_(limit), block_(sizeof(float) * kLanes * rows) {}

    /// Throws InputError where the tree grows past the limit.
    void add(std::span<const KdNode> nodes) {
        uint64_t bytes = nodes.size_bytes();
        for (const KdNode& node : nodes)
            if (node.is_leaf()) bytes += block_ * blocks_for(node.references());
        if (bytes_ += bytes; bytes_ <= limit_) return;
        throw InputError("kd-tree", "would take more than " + std::to_string(limit_ >> 20) +
                                        " MB under these options of accel: use larger leaves, or less geometry");
    }

private:
    std::atomic<uint64_t> bytes_{0};
    uint64_t limit_, block_;
};

}  // namespace tress
