// SPDX-License-Identifier: MIT
// Leaf data: primitives in blocks of 16, row by row (SoA), so that a vector of any width up to 16 loads one field of
// its lanes at once. Padding lanes have the identity kNone; as segments they start at NaN, so that no test
// passes them, as triangles they have no area.
#pragma once

#include <cstdint>
#include <span>

#include "core/aligned_array.h"

namespace tress {

inline constexpr uint32_t kLanes = 16;
inline constexpr uint32_t kNone = 0xffffffffu;

/// Rows of a block, in order.
namespace segment_row {
enum : uint32_t { x, y, z, dx, dy, dz, radius, id, radius_slope };  // start, end - start, radius at the start …
inline constexpr uint32_t kConstantRadius = 8, kVaryingRadius = 9;  // … radius_slope: only where radii vary
}  // namespace segment_row
namespace triangle_row {
enum : uint32_t { ax, ay, az, bx, by, bz, cx, cy, cz, id };
inline constexpr uint32_t kRows = 10;
}  // namespace triangle_row

struct LeafBlocks {
    uint32_t rows = 0;           // a block
    AlignedArray<float> values;  // blocks x rows x kLanes; identities are stored as bits

    const float* block(uint32_t index) const { return values.data() + size_t(index) * rows * kLanes; }
};
inline size_t bytes(const LeafBlocks& b) { return b.values.size() * sizeof(float); }
inline uint32_t blocks_for(uint32_t references) { return (references + kLanes - 1) / kLanes; }

}  // namespace tress
