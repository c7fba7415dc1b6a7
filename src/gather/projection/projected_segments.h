// SPDX-License-Identifier: MIT
// All segments as projection reads them one after another.
#pragma once

#include <bit>

#include "core/aligned_array.h"
#include "core/segments.h"

namespace tress {

/// A SegmentView's segments as their middle, unit tangent, length and mean radius. Neighbours on a strand often fall in
/// one cell, where one sum waits for the other: so rows run through kStreams parts of the list in turn, and row i holds
/// segment_of(i). Rows are padded to whole vectors with segments without area. A vector's columns follow one another in
/// memory: as many long arrays would share the few places of a cache that their like addresses fall on.
struct ProjectedSegments {
    static constexpr size_t kStreams = 16;
    enum Column {
        kX,  // middle
        kY,
        kZ,
        kUx,  // tangent
        kUy,
        kUz,
        kLength,
        kRadius,
        kTaper,     // half the difference of the radii, end less start
        kOriginal,  // first segment of the scene that the row stands for, as bits
        kColumns
    };

    AlignedArray<float> values;  // stream x kColumns x kStreams
    size_t stream = 0;           // segments of a part
    uint32_t stands_for = 1;     // segments of the scene, one after another, by each

    ProjectedSegments() = default;
    explicit ProjectedSegments(size_t rows);  // a multiple of kStreams, without area

    size_t rows() const { return stream * kStreams; }
    /// At least the number of segments for padding.
    size_t segment_of(size_t row) const { return row % kStreams * stream + row / kStreams; }
    size_t row_of(size_t segment) const { return segment % stream * kStreams + segment / stream; }

    static size_t place(size_t row, Column c) { return (row / kStreams * kColumns + c) * kStreams + row % kStreams; }
    float& at(size_t row, Column c) { return values[place(row, c)]; }
    float at(size_t row, Column c) const { return values[place(row, c)]; }
    Vec3 middle(size_t row) const { return {at(row, kX), at(row, kY), at(row, kZ)}; }
    Vec3 tangent(size_t row) const { return {at(row, kUx), at(row, kUy), at(row, kUz)}; }
    uint32_t original(size_t row) const { return std::bit_cast<uint32_t>(at(row, kOriginal)); }
    void set_original(size_t row, uint32_t segment) { at(row, kOriginal) = std::bit_cast<float>(segment); }
};

ProjectedSegments make_projected_segments(const SegmentView& segments);

size_t bytes(const ProjectedSegments& segments);

}  // namespace tress
