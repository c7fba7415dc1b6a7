// SPDX-License-Identifier: MIT
// Builds kd-trees. The same tree whatever the number of threads.
#pragma once

#include "accel/kd_tree.h"
#include "accel/tree_limits.h"
#include "core/mesh.h"
#include "core/options.h"
#include "core/segments.h"

namespace tress {

/// Throw InputError where the tree would pass a limit.
KdTree build_segment_tree(const SegmentView& segments, const AccelOptions& options, const TreeLimits& limits = {});
KdTree build_triangle_tree(const TriangleMesh& mesh, const AccelOptions& options, const TreeLimits& limits = {});

}  // namespace tress
