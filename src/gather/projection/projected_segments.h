// SPDX-License-Identifier: MIT
// All segments as projection reads them one after another.
#pragma once

#include <vector>

#include "core/aligned_array.h"
#include "core/segments.h"

namespace tress {

/// A SegmentView's segments as their middle, unit tangent, length and mean radius. Neighbours on a strand often fall in
/// one cell, where one sum waits for the other: so rows run through kStreams parts of the list in turn, and row i holds
/// segment_of(i). Rows are padded to whole vectors with segments without area.
struct ProjectedSegments {
    static constexpr size_t kStreams = 16;

    AlignedArray<float> x, y, z;     // middle
    AlignedArray<float> ux, uy, uz;  // tangent
    AlignedArray<float> length, radius;
    AlignedArray<float> taper;  // half the difference of the radii, end less start
    size_t segments = 0;
    size_t stream = 0;               // segments of a part
    std::vector<uint32_t> original;  // first segment of the scene that each stands for, or empty: itself
    uint32_t stands_for = 1;         // segments of the scene, one after another

    size_t rows() const { return stream * kStreams; }
    /// At least `segments` for padding.
    size_t segment_of(size_t row) const { return row % kStreams * stream + row / kStreams; }
    size_t row_of(size_t segment) const { return segment % stream * kStreams + segment / stream; }
    uint32_t original_of(size_t segment) const { return original.empty() ? uint32_t(segment) : original[segment]; }
};

/// Rows without anything, `rows` a multiple of kStreams.
ProjectedSegments make_rows(size_t rows);

ProjectedSegments make_projected_segments(const SegmentView& segments);

size_t bytes(const ProjectedSegments& segments);

}  // namespace tress
