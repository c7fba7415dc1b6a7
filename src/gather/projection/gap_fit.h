// SPDX-License-Identifier: MIT
// Which shares of gaps (GapShares) fit what rays say.
#pragma once

#include <array>
#include <numeric>
#include <vector>

#include "gather/projection/cell_light.h"

namespace tress {

using Means = std::vector<double>;  // luminance that leaves each of some points

inline double sum(const Means& means) { return std::accumulate(means.begin(), means.end(), 0.0); }

inline constexpr float kLeastGap = -1, kMostGap = 4;   // below 0: fibers side by side, which hide less of each other
inline constexpr GapShares kUsualGaps = {1.5f, 0.5f};  // about what is right for hair everywhere
inline constexpr double kScatterSpread = 0.25;         // of the share of scatter, from scene to scene

/// To be tried on the points: nothing is taken off that the gap does not outweigh in every cell.
inline constexpr std::array kTriedGaps = {GapShares{0, 0}, GapShares{1, 0}, GapShares{1, 0.25f}};

/// Of shares that leave no bias, those of least squares, light being linear in both. `tried`: with kTriedGaps.
/// Scatter counts as known beforehand (kUsualGaps, kScatterSpread), which decides where points tell little of it. In
/// range at any input; without a bias but where the range ends.
GapShares fit_gaps(const Means& truth, const std::array<Means, 3>& tried);

}  // namespace tress
