// SPDX-License-Identifier: MIT
// What the rows of a study of trees say together: best and worst, and whether the cost that the heuristic predicts
// orders them as the clock does.
#pragma once

#include <vector>

#include "tools/study/study_log.h"

namespace tress {

/// {"line": "spread", "trees" (that were not refused), "refused", "best", "worst" (rows, by times_as_fast), "rays":
/// {"primary": {"best", "worst" (rows), "most", "least" (million rays a second), "ratio", "orders" (of magnitude),
/// "ratio_at_depth" (of the trees whose limit of depth is the first row's), "predicted_correlation" (rank, of sah_cost
/// with the time a ray), "counted_correlation" (of the cost of the steps and tests that were counted with it)}, ...},
/// "text": a paragraph}. `rows`: tree_result.h; the first is what others are told against. Correlations are null where
/// there are fewer than three trees.
Json tree_spread(const std::vector<Json>& rows);

}  // namespace tress
