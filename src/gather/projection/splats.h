// SPDX-License-Identifier: MIT
// Small pieces of hair as a point sees them, about to be added to its cells: a direction, a solid angle, an opacity.
#pragma once

#include <cstdint>

#include "core/aligned_array.h"

namespace tress {

/// Rows belong together by index. Writers store whole vectors: up to kPadding rows past `size` may hold anything.
struct Splats {
    static constexpr size_t kCapacity = 2048, kPadding = 64;

    AlignedArray<float> x, y, z;        // from the point towards the piece, of any length but 0
    AlignedArray<float> solid_angle;    // steradian
    AlignedArray<int32_t> opacity_row;  // of HairOpacity
    AlignedArray<int32_t> cell;         // as found from the direction
    AlignedArray<float> coverage;       // of the cell's solid angle
    size_t size = 0;

    Splats()
        : x(kCapacity + kPadding),
          y(kCapacity + kPadding),
          z(kCapacity + kPadding),
          solid_angle(kCapacity + kPadding),
          opacity_row(kCapacity + kPadding),
          cell(kCapacity + kPadding),
          coverage(kCapacity + kPadding) {}

    bool has_room(size_t rows) const { return size + rows <= kCapacity; }
};

}  // namespace tress
