// SPDX-License-Identifier: MIT
// How well one figure orders what another measures.
#pragma once

#include <span>

namespace tress {

/// Spearman's rank correlation of pairs, as many in each: 1 where both have the same order, -1 where it is the reverse.
/// Equal values share the mean of their ranks. NaN with fewer than two pairs, or where all values of one are equal.
/// Spearman, "The proof and measurement of association between two things", 1904.
double rank_correlation(std::span<const double> a, std::span<const double> b);

}  // namespace tress
