// SPDX-License-Identifier: MIT
// The surface area heuristic: what a split of a cell is expected to cost a ray that passes the cell, in tests of one
// primitive (MacDonald & Booth 1990; constants and empty bonus as in Wald & Havran 2006).
#pragma once

#include <optional>

#include "accel/reference.h"
#include "core/options.h"

namespace tress {

struct Split {
    uint32_t axis;
    float position;
    float cost;
    uint32_t left, right;  // references of either side, before clipping
};

/// Costs of cuts of one cell across one axis. Linear in the number of references: costs in whole SIMD blocks make
/// splits look free and the tree explode.
class AxisCost {
public:
    AxisCost(const AccelOptions& options, const Bounds& cell, uint32_t axis)
        : traversal_(options.traversal_cost),
          full_(1 - options.empty_bonus),
          lo_(cell.lo[int(axis)]),
          hi_(cell.hi[int(axis)]) {
        // In units of the cell's longest side: areas of very small and very large scenes stay in the range of floats.
        const float unit = 1 / max_component(cell.extent());
        const Vec3 e = cell.extent() * unit;
        const float a = e[int(axis + 1) % 3], b = e[int(axis + 2) % 3];
        cap_ = a * b;
        girth_ = (a + b) * unit;
        const float inverse = 1 / half_area(hi_ - lo_);
        inverse_area_ = std::isfinite(inverse) ? inverse : 0;
    }

    /// Whether a cut at `s` leaves both sides some floats, in a cell that has an area.
    bool cuts(float s) const { return s > lo_ && s <= hi_ && inverse_area_ > 0; }

    /// Counts as floats, so that many candidates are computed as vectors.
    float operator()(float s, float left, float right) const {
        const float tests = half_area(s - lo_) * left + half_area(hi_ - s) * right;
        const float cost = traversal_ + tests * inverse_area_;
        return (left == 0) | (right == 0) ? full_ * cost : cost;
    }

private:
    float half_area(float length) const { return cap_ + length * girth_; }  // in units squared
    float traversal_, full_, lo_, hi_, cap_, girth_, inverse_area_;
};

/// Keeps the cheapest split of those offered in the order of axis, then position: of equal cost, the first.
inline void keep_cheaper(std::optional<Split>& best, const AxisCost& cost, uint32_t axis, float s, uint32_t left,
                         uint32_t right) {
    if (!cost.cuts(s)) return;
    const float c = cost(s, float(left), float(right));
    if (!best || c < best->cost) best = Split{axis, s, c, left, right};
}

/// A lower bound of any split's cost: smaller nodes need no search.
inline float least_split_cost(const AccelOptions& options) {
    return options.traversal_cost * (1 - options.empty_bonus);
}

}  // namespace tress
