// SPDX-License-Identifier: MIT
// Plots of the results of a study of trees.
#pragma once

#include <vector>

#include "tools/study/page.h"

namespace tress {

/// Time a ray against the cost that was predicted, and against the cost of what was counted; then a plot for each
/// option with three values or more among rows that differ in it alone. `rows`: tree_result.h.
std::vector<PagePlot> tree_plots(const std::vector<Json>& rows);

}  // namespace tress
