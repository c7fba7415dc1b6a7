// SPDX-License-Identifier: MIT
// All segments as projection reads them one after another.
#pragma once

#include "core/aligned_array.h"
#include "core/segments.h"

namespace tress {

/// Segment i of a SegmentView as its middle, unit tangent, length and mean radius. Rows are padded by kPadding.
struct ProjectedSegments {
    static constexpr size_t kPadding = 16;

    AlignedArray<float> x, y, z;     // middle
    AlignedArray<float> ux, uy, uz;  // tangent
    AlignedArray<float> length, radius;
    size_t size = 0;
};

ProjectedSegments make_projected_segments(const SegmentView& segments);

size_t bytes(const ProjectedSegments& segments);

}  // namespace tress
