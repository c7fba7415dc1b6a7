// SPDX-License-Identifier: MIT
// The exact search: every face of every box is a candidate (Wald & Havran 2006). A cut at s holds to its left what has
// lo < s, to its right what has hi >= s; so useful cuts are at lo (the box is right of it) and just above hi (left of
// it), and flat boxes need no rule of their own.
#pragma once

#include <span>
#include <vector>

#include "accel/cost_model.h"

namespace tress {

/// A face of a box: its position and whose it is.
struct Face {
    float at;
    uint32_t reference;
};
inline float position(float face) { return face; }
inline float position(const Face& face) { return face.at; }

/// Candidates across one axis; `lo` and `hi` hold the lower and upper faces of all references, sorted.
template <class AnyFace>
void sweep_axis(std::span<const AnyFace> lo, std::span<const AnyFace> hi, const AxisCost& cost, uint32_t axis,
                std::optional<Split>& best) {
    const size_t n = lo.size();
    size_t begun = 0, ended = 0;  // lower faces < s, upper faces < s
    while (ended < n) {
        const float end = above(position(hi[ended]));
        const float s = begun < n ? std::min(position(lo[begun]), end) : end;
        while (ended < n && position(hi[ended]) < s) ++ended;
        keep_cheaper(best, cost, axis, s, uint32_t(begun), uint32_t(n - ended));
        while (begun < n && position(lo[begun]) <= s) ++begun;
    }
}

/// Work space of sweep_split, kept between calls.
struct SortedFaces {
    std::vector<float> lo, hi;
};

/// Sorts the faces of one node, axis by axis, and sweeps them: O(n log n) a node.
std::optional<Split> sweep_split(std::span<const Reference> references, const Bounds& cell, const AccelOptions& options,
                                 SortedFaces& faces);

}  // namespace tress
