// SPDX-License-Identifier: MIT
// What the hair lets through in each cell about a point.
#pragma once

#include "core/aligned_array.h"
#include "gather/projection/igloo.h"

namespace tress {

/// For what is lost by taking the exponential of a cell's mean depth, a share of the like gap between neighbouring
/// cells is added: the mean over four neighbours of (T + Tn) / 2 - sqrt(T Tn). Part of it is no gap but scatter, by
/// where the splats of hair happen to fall. It makes a cell differ from opposite neighbours alike, which hair that is
/// denser on one side does not: a share of (the mean of both - own)^2, in sqrt(T), is taken off, once for each axis
/// that has both.
struct GapShares {
    float gap = 0, scatter = 0;
};

/// Transmittance of a cell: what hair next to the point lets through, times exp(-depth) with shares of gaps, kept in
/// [0, 1], of other hair.
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
