// SPDX-License-Identifier: MIT
// What the hair lets through in each cell about a point.
#pragma once

#include "core/aligned_array.h"
#include "gather/projection/igloo.h"

namespace tress {

/// Transmittance of a cell: exp(-depth), and for what is lost by taking the exponential of a mean depth, a share of the
/// like gap between neighbouring cells: T + gap * mean over four neighbours of ((T + Tn) / 2 - sqrt(T Tn)), kept in [0,
/// 1].
struct CellTransmittance {
    AlignedArray<float> channel[3];  // one a cell of the dome; gray: only the first

    Rgb operator()(uint32_t cell, bool gray) const {
        const float first = channel[0][cell];
        return gray ? Rgb(first) : Rgb(first, channel[1][cell], channel[2][cell]);
    }
};

struct CellLight {
    CellTransmittance all, in_sight;  // of all hair; of what is before the polygons among it, where there are any
    size_t cells = 0;
    bool gray = true;

    Rgb transmittance(uint32_t cell) const { return all(cell, gray); }
    Rgb transmittance_in_sight(uint32_t cell) const { return in_sight(cell, gray); }
};

}  // namespace tress
