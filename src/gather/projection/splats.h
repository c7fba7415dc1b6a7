// SPDX-License-Identifier: MIT
// Small pieces of hair as a point sees them, about to be added to its cells: a direction, a solid angle, an opacity.
#pragma once

#include <cstdint>

#include "core/aligned_array.h"

namespace tress {

/// In cells that are found. Rows belong together by index. Writers store whole vectors: up to kPadding rows past `size`
/// may hold anything.
struct CellSplats {
    static constexpr size_t kCapacity = 2048, kPadding = 64;

    AlignedArray<int32_t> cell, opacity_row;  // opacity_row: of HairOpacity
    AlignedArray<float> coverage;             // of the cell's solid angle
    size_t size = 0;

    CellSplats() : cell(kCapacity + kPadding), opacity_row(kCapacity + kPadding), coverage(kCapacity + kPadding) {}

    bool has_room(size_t rows) const { return size + rows <= kCapacity; }
};

/// Those whose cells are to be found from their directions.
struct Splats : CellSplats {
    AlignedArray<float> x, y, z;      // from the point towards the piece, of any length but 0
    AlignedArray<float> solid_angle;  // steradian

    Splats()
        : x(kCapacity + kPadding),
          y(kCapacity + kPadding),
          z(kCapacity + kPadding),
          solid_angle(kCapacity + kPadding) {}
};

}  // namespace tress
