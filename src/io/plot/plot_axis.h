// SPDX-License-Identifier: MIT
// Axes. They measure in "units": values, or decades if they are logarithmic.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>

namespace tress::svg {

/// None where the axis cannot show it.
std::optional<double> units(bool log, double v);

struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;

    bool empty() const { return low > high; }
    double span() const { return high - low; }
    bool contains(double v) const { return v >= low && v <= high; }
    void add(double v) {
        low = std::min(low, v);
        high = std::max(high, v);
    }
};

/// With a margin; never without a span.
Range widened(const Range& data, bool log);

struct Axis {
    bool log = true;
    Range range;
    double from = 0, to = 0;  // where the range begins and ends

    double at(double v) const { return from + (v - range.low) / range.span() * (to - from); }
};

}  // namespace tress::svg
