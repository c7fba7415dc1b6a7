// SPDX-License-Identifier: MIT
// Which shares of gaps (GapShares) fit what rays say.
#pragma once

#include <array>
#include <numeric>
#include <vector>

#include "gather/projection/cell_light.h"

namespace tress {

using Luminances = std::vector<double>;  // of the light that leaves each of some points

inline double total(const Luminances& light) { return std::accumulate(light.begin(), light.end(), 0.0); }

inline constexpr float kLeastGap = -1, kMostGap = 4;   // below 0: fibers side by side, which hide less of each other
inline constexpr float kMostScatter = 4;               // least: 0
inline constexpr GapShares kUsualGaps = {1.5f, 0.5f};  // about what is right for hair everywhere
inline constexpr double kScatterSpread = 0.25;         // of the share of scatter, from scene to scene

/// To be tried on the points: none; the gap; and as much scatter as the gap outweighs in every cell.
inline constexpr std::array kTriedGaps = {GapShares{0, 0}, GapShares{1, 0}, GapShares{1, 0.25f}};

/// Minimises squares of (light - truth) + noise * ((scatter - usual) / kScatterSpread)^2, light being linear in both
/// shares, among shares that give the truth's total. `noise` is the square that the best fit leaves a point. `tried`:
/// light with kTriedGaps. Shares stay in range, where the total may be missed; usual ones where cells do not differ.
GapShares fit_gaps(const Luminances& truth, const std::array<Luminances, 3>& tried);

}  // namespace tress
