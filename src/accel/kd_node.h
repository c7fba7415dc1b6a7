// SPDX-License-Identifier: MIT
// A node of the kd-tree in 8 bytes.
#pragma once

#include <bit>
#include <cassert>
#include <cstdint>

namespace tress {

enum class Axis : uint32_t { x, y, z };

/// Inner: split position, axis, index of the left child; the right child is the next node. The left cell is x < split,
/// the right one x >= split. Leaf: first block and number of references.
class KdNode {
public:
    static constexpr uint32_t kTagBits = 2, kTagMask = (1u << kTagBits) - 1, kLeaf = 3;
    static constexpr uint32_t kMaxIndex = (1u << (32 - kTagBits)) - 1;

    static KdNode inner(Axis axis, float split, uint32_t left) {
        assert(left <= kMaxIndex);
        return {std::bit_cast<uint32_t>(split), (left << kTagBits) | uint32_t(axis)};
    }
    static KdNode leaf(uint32_t first_block, uint32_t references) {
        assert(first_block <= kMaxIndex);
        return {references, (first_block << kTagBits) | kLeaf};
    }
    KdNode() = default;

    bool is_leaf() const { return (tagged_ & kTagMask) == kLeaf; }
    uint32_t axis() const { return tagged_ & kTagMask; }
    float split() const { return std::bit_cast<float>(payload_); }
    uint32_t left() const { return tagged_ >> kTagBits; }
    uint32_t first_block() const { return tagged_ >> kTagBits; }
    uint32_t references() const { return payload_; }

private:
    KdNode(uint32_t payload, uint32_t tagged) : payload_(payload), tagged_(tagged) {}
    uint32_t payload_ = 0, tagged_ = kLeaf;
};
static_assert(sizeof(KdNode) == 8);

}  // namespace tress
