// SPDX-License-Identifier: MIT
#include "io/plot/plot_axis.h"

#include <cmath>

namespace tress::svg {
namespace {

constexpr double kMargin = 0.05;                 // of the span, on either side
constexpr double kHuge = 1e300, kTiny = 1e-280;  // bounds of magnitudes on linear axes
constexpr double kLeastLogSpan = 1e-6;           // decades
constexpr double kLeastLinearSpan = 1e-9;        // of the largest magnitude

}  // namespace

std::optional<double> units(bool log, double v) {
    if (!std::isfinite(v) || (log && v <= 0)) return {};
    if (log) return std::log10(v);
    return std::abs(v) < kTiny ? 0 : std::clamp(v, -kHuge, kHuge);
}

Range widened(const Range& data, bool log) {
    const double largest = std::max(std::abs(data.low), std::abs(data.high));
    const bool level = data.span() <= (log ? kLeastLogSpan : kLeastLinearSpan * largest);
    const double level_margin = log || largest == 0 ? 0.5 : 0.5 * largest;
    const double margin = level ? level_margin : kMargin * data.span();
    return {data.low - margin, data.high + margin};
}

}  // namespace tress::svg
