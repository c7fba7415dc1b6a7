// SPDX-License-Identifier: MIT
// One run of a study of trees: a tree that is built, and traced by the rays of a render.
#pragma once

#include <span>

#include "gather/tree_measure.h"
#include "tools/study/accel/tree_row.h"
#include "tools/study/study_scene.h"

namespace tress {

/// By what the log knows it: the scene, its options and the row's, the machine, the program.
std::string tree_key(const StudyScene& scene, const TreeRow& row, int round, double seconds);

/// The line of the run: "key", "row", "settings", "round", "build_seconds", "statistics" {accel/statistics.h}, "rates"
/// {"primary": {"mrays_per_second", "steps", "leaves", "tests", "traced", "counted", "seconds"}, ...}; of a tree that
/// would be too large, "refused" (why) in the place of its figures. `seconds`: of tracing a set.
Json run_tree(const StudyScene& scene, const SegmentView& segments, std::span<const TreeRays> rays, const TreeRow& row,
              int round, double seconds);

}  // namespace tress
