// SPDX-License-Identifier: MIT
// Builds kd-trees. The same tree whatever the number of threads.
#pragma once

#include "accel/kd_tree.h"
#include "core/mesh.h"
#include "core/options.h"
#include "core/segments.h"

namespace tress {

/// Throws InputError where the tree would need more nodes or blocks than `index_limit`.
KdTree build_segment_tree(const SegmentView& segments, const AccelOptions& options,
                          uint32_t index_limit = KdNode::kMaxIndex);
KdTree build_triangle_tree(const TriangleMesh& mesh, const AccelOptions& options,
                           uint32_t index_limit = KdNode::kMaxIndex);

}  // namespace tress
