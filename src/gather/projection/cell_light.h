// SPDX-License-Identifier: MIT
// What the hair lets through in each cell about a point.
#pragma once

#include "core/aligned_array.h"
#include "gather/projection/igloo.h"

namespace tress {

/// Transmittance of a cell: exp(-depth), and for what is lost by taking the exponential of a mean depth, a share of the
/// like gap between neighbouring cells: T + gap * mean over four neighbours of ((T + Tn) / 2 - sqrt(T Tn)), at most 1.
struct CellLight {
    AlignedArray<float> channel[3];  // one a cell of the dome; gray: only the first
    size_t cells = 0;
    bool gray = true;

    Rgb transmittance(uint32_t cell) const {
        const float first = channel[0][cell];
        return gray ? Rgb(first) : Rgb(first, channel[1][cell], channel[2][cell]);
    }
};

}  // namespace tress
