// SPDX-License-Identifier: MIT
// Lengths of a plot, in units of its viewBox.
#pragma once

#include <cstddef>

namespace tress::svg {

inline constexpr double kWidth = 720, kLeastHeight = 440, kTallestPlot = 560;
inline constexpr double kRight = 536, kBelowPlot = 50, kEdge = 10;
inline constexpr double kFont = 11, kTitleFont = 15, kTitleLine = 19, kBold = 1.2;  // bold letters are wider
inline constexpr double kLegendLeft = 556, kSample = 26, kLegendText = kLegendLeft + kSample + 7;
inline constexpr double kLegendLine = 13, kLegendGap = 7;
inline constexpr size_t kLegendLines = 3, kTitleLines = 2;
inline constexpr double kMajorTick = 5, kMinorTick = 3, kCap = 3;

}  // namespace tress::svg
