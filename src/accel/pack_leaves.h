// SPDX-License-Identifier: MIT
// Copies the primitives of every leaf into blocks of their own: reading them through indices costs a traversal a factor
// of two.
#pragma once

#include <tbb/parallel_for.h>

#include "accel/index_limit.h"
#include "accel/kd_tree.h"

namespace tress {

/// A lane of a block: writes one value into each row.
class Lane {
public:
    explicit Lane(float* first) : value_(first) {}
    float& operator[](uint32_t row) const { return value_[row * kLanes]; }
    void set_id(uint32_t row, uint32_t id) const { (*this)[row] = std::bit_cast<float>(id); }

private:
    float* value_;
};

/// Makes leaves of `topology` name blocks of `rows` rows in place of references, and fills the blocks:
/// write(lane, primitive), and pad(lane) for lanes that are left over. Throws InputError past `index_limit` blocks.
template <class Write, class Pad>
LeafBlocks pack_leaves(KdTopology& topology, uint32_t rows, uint32_t index_limit, const Write& write, const Pad& pad) {
    constexpr size_t kGrain = 256;
    std::vector<uint32_t> first_reference(topology.nodes.size());
    uint64_t blocks = 0;
    for (const KdNode& node : topology.nodes)
        if (node.is_leaf()) blocks += blocks_for(node.references());
    check_index_limit("blocks of leaf data", blocks, index_limit);

    uint32_t next = 0;
    for (size_t i = 0; i < topology.nodes.size(); ++i) {
        KdNode& node = topology.nodes[i];
        if (!node.is_leaf()) continue;
        first_reference[i] = node.first_block();
        node = KdNode::leaf(next, node.references());
        next += blocks_for(node.references());
    }
    LeafBlocks leaves{rows, AlignedArray<float>(size_t(blocks) * rows * kLanes)};
    tbb::parallel_for(tbb::blocked_range<size_t>(0, topology.nodes.size(), kGrain), [&](const auto& range) {
        for (size_t i = range.begin(); i < range.end(); ++i) {
            const KdNode& node = topology.nodes[i];
            if (!node.is_leaf()) continue;
            const uint32_t* id = topology.references.data() + first_reference[i];
            float* const first = leaves.values.data() + size_t(node.first_block()) * rows * kLanes;
            for (uint32_t k = 0; k < blocks_for(node.references()) * kLanes; ++k) {
                const Lane lane(first + size_t(k / kLanes) * rows * kLanes + k % kLanes);
                if (k < node.references())
                    write(lane, id[k]);
                else
                    pad(lane);
            }
        }
    });
    return leaves;
}

}  // namespace tress
