// SPDX-License-Identifier: MIT
// The exact area of a convex outline in the texels of one row. By Green's theorem it is a sum over edges: to the right
// of an edge that rises through the row by dy, dy of each texel is inside, and of a texel that it passes through the
// part that is right of it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "gather/shadow_maps/ribbon.h"

namespace tress {

/// Integral up to `x` of clamp(x, 0, most).
template <class T>
T clamped_integral(T x, T most) {
    const T within = std::clamp(x, T(0), most);
    return within * (std::max(x, T(0)) - T(0.5) * within);
}

class OutlineRow {
public:
    OutlineRow(const RibbonOutline& outline, int y) {
        for (int k = 0; k < outline.corners; ++k)
            add(outline.corner[size_t(k)], outline.corner[size_t(k + 1 == outline.corners ? 0 : k + 1)], y);
    }

    /// Texels of the row that anything may be in.
    int first(int low) const { return edges_ == 0 ? kNone : std::max(low, int(std::min(leftmost_, double(kNone)))); }
    int last(int high) const { return edges_ == 0 ? 0 : int(std::min(std::ceil(rightmost_), double(high))); }

    double coverage(int x) const {
        double sum = 0;
        for (int k = 0; k < edges_; ++k) sum += edge_[size_t(k)].rise * edge_[size_t(k)].inside(x + 1);
        return std::min(std::abs(sum), 1.0);
    }

private:
    static constexpr int kNone = 1 << 30;

    /// The part of an edge in the row: it goes from x = low to x = high.
    struct Edge {
        double rise, low, high;

        /// Mean over the edge of the part of [right - 1, right] that is right of it.
        double inside(double right) const {
            const double from = right - high, to = right - low;
            if (to <= 0) return 0;
            if (from >= 1) return 1;
            constexpr double kUpright = 0x1p-16;  // narrower: the difference would be rounding
            if (to - from < kUpright) return std::clamp(0.5 * (from + to), 0.0, 1.0);
            return (clamped_integral(to, 1.0) - clamped_integral(from, 1.0)) / (to - from);
        }
    };

    void add(const glm::dvec2& p, const glm::dvec2& q, int y) {
        const double from = std::clamp(p.y, double(y), double(y + 1)), to = std::clamp(q.y, double(y), double(y + 1));
        if (from == to) return;
        const double slope = (q.x - p.x) / (q.y - p.y);
        const double a = p.x + (from - p.y) * slope, b = from == p.y && to == q.y ? q.x : p.x + (to - p.y) * slope;
        edge_[size_t(edges_++)] = {to - from, std::min(a, b), std::max(a, b)};
        leftmost_ = std::min(leftmost_, std::min(a, b));
        rightmost_ = std::max(rightmost_, std::max(a, b));
    }

    std::array<Edge, RibbonOutline::kMost> edge_;
    int edges_ = 0;
    double leftmost_ = 1e300, rightmost_ = -1e300;
};

}  // namespace tress
