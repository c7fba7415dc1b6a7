// SPDX-License-Identifier: MIT
// What follows from the runs of a study of trees: for each row what its tree is like and how fast rays pass it.
#pragma once

#include <vector>

#include "tools/study/accel/tree_row.h"
#include "tools/study/study_log.h"

namespace tress {

/// A row with its runs (tree_run.h), one a round.
struct MeasuredTree {
    TreeRow row;
    std::vector<Json> runs;
};

/// What rows are told against: options of the scene, without a row's, and its number of segments.
struct TreeBasis {
    Options options;
    uint64_t segments = 0;
};

/// One line a row, in order: "line": "row", "row", "settings", "rounds", "accel" (all its options, as text),
/// "build_seconds" (median over rounds), "statistics" (as of a run, with "bytes_per_segment"), "sah_cost" (expected for
/// a ray that nothing stops, in tests of a segment, a step at the basis' accel.traversal_cost whatever the row's),
/// "rays": {"primary": {"mrays_per_second" (median), "lowest", "highest", "microseconds" (a ray and thread, of the
/// median), "times_as_fast" (as of the first row), "steps", "leaves", "tests" (a ray), "cost" (these, as sah_cost)},
/// ...}, "times_as_fast" (geometric mean over the sets). A tree that was refused: "refused" in the place of its
/// figures.
std::vector<Json> tree_results(const std::vector<MeasuredTree>& trees, const TreeBasis& basis, int threads);

/// Sets of rays of any row, in order.
std::vector<std::string> ray_sets(const std::vector<Json>& rows);

}  // namespace tress
