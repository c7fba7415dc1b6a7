// SPDX-License-Identifier: MIT
// Segments: what the hair tree is built over. A segment joins point p and point p + 1; its identity is its place in
// the list. Segments that no ray can meet, or that are not finite, are left out of the list and counted.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/bounds.h"
#include "core/strands.h"

namespace tress {

/// A view of points and of the segments between them. `linked`: consecutive segments that share a point are one
/// strand, so that a crossing at their joint is one crossing; otherwise every segment stands alone and has round ends.
struct SegmentView {
    std::span<const float> x, y, z;
    std::span<const float> radius;    // one a point, or empty: constant_radius
    std::span<const uint32_t> point;  // one a segment: its first point; the second is the next
    float constant_radius = 0;
    bool linked = true;

    size_t size() const { return point.size(); }
    Vec3 start(size_t segment) const { return at(point[segment]); }
    Vec3 end(size_t segment) const { return at(point[segment] + 1); }
    float start_radius(size_t segment) const { return radius_at(point[segment]); }
    float end_radius(size_t segment) const { return radius_at(point[segment] + 1); }

private:
    Vec3 at(uint32_t p) const { return {x[p], y[p], z[p]}; }
    float radius_at(uint32_t p) const { return radius.empty() ? constant_radius : radius[p]; }
};

/// What becomes of the segment from point p to p + 1. Dropped: a point or radius that is not finite, a negative radius,
/// a length of at most max(16 ulp of its coordinates, a thousandth of its radius). Of radius 0: unseen.
enum class SegmentFate { kept, dropped, unseen };
SegmentFate fate_of_segment(const StrandSet& strands, uint32_t p);

struct SegmentList {
    std::vector<uint32_t> point;  // first point of each segment kept, ascending
    uint64_t dropped = 0;         // as SegmentFate says; those of radius 0 are left out and not counted
};

/// Segments of `strands` worth tracing.
SegmentList list_segments(const StrandSet& strands);

SegmentView view(const StrandSet& strands, const SegmentList& list);

/// Segments [first, last]: what a ray that starts on one of them must not meet.
struct SegmentRange {
    uint32_t first, last;
};

/// `segment`, those of its strand that touch it, and those within kOwnStrandRadii of its radius along the strand: a ray
/// that leaves a fiber at 80 degrees to its normal is clear of a straight continuation of it by then.
inline constexpr float kOwnStrandRadii = 16;
SegmentRange own_strand(const SegmentView& segments, uint32_t segment);

/// Whether `after`, a later segment, goes on where `before` ends: at the same point, or, where a segment between them
/// was too short to be kept, as near as that.
bool joined(const SegmentView& segments, uint32_t before, uint32_t after);

/// Box of segments, radii included.
Bounds bounds(const SegmentView& segments, const SegmentRange& range);
Bounds bounds(const SegmentView& segments);  // all

}  // namespace tress
