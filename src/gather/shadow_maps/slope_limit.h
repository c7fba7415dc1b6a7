// SPDX-License-Identifier: MIT
// Which lines pass through a row of vertical gaps: those between a steepest and a flattest one, kept as gaps come in
// (O'Rourke 1981, "An on-line algorithm for fitting straight lines between data ranges"). Constant time a gap, on
// average over a row.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace tress {

/// The line of the greatest slope, up to `cap`, through all gaps [floor, ceiling] so far; right of them no other line
/// is higher. The line of the least slope is that of the mirrored gaps [-ceiling, -floor].
/// Invariant: hull[front .. last] is the upper hull of those floors that the line can still come to touch.
struct SlopeLimit {
    static constexpr double kNoCap = std::numeric_limits<double>::infinity();

    /// Makes room for rows of so many gaps.
    void reserve(size_t gaps) {
        if (hull_.size() < gaps) hull_.resize(gaps);
    }

    /// From here on only gaps with x > 0 count, in order, and the one at 0.
    void start(double floor, double ceiling, double greatest_slope) {
        hull_[0] = {0, floor};
        front_ = last_ = 0;
        x_ = 0, y_ = ceiling;
        slope_ = cap_ = greatest_slope;
    }

    double at(double x) const { return y_ + slope_ * (x - x_); }  // x > those so far

    /// Needs floor <= at(x).
    void add(double x, double floor, double ceiling) {
        if (ceiling < at(x)) hang_from({x, ceiling});
        const Point p{x, floor};
        size_t last = last_;
        while (last > front_ && !steeper(hull_[last - 1], hull_[last], p)) --last;
        hull_[last_ = last + 1] = p;
    }

private:
    struct Point {
        double x, y;
    };

    /// Whether the slope from `a` to `top` is greater than that from `b` to it. Both lie left of it.
    static bool steeper(const Point& a, const Point& b, const Point& top) {
        return (top.y - a.y) * (top.x - b.x) > (top.y - b.y) * (top.x - a.x);
    }

    /// The line through `top` that touches the hull. Where a point of the hull is passed over, no later line, which is
    /// less steep, comes back to it.
    void hang_from(const Point& top) {
        while (front_ < last_ && !steeper(hull_[front_ + 1], hull_[front_], top)) ++front_;
        const Point& touched = hull_[front_];
        x_ = top.x, y_ = top.y;
        slope_ = std::min((top.y - touched.y) / (top.x - touched.x), cap_);
    }

    std::vector<Point> hull_;
    size_t front_ = 0, last_ = 0;
    double x_ = 0, y_ = 0, slope_ = 0, cap_ = 0;
};

}  // namespace tress
