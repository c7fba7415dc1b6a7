// SPDX-License-Identifier: MIT
// Segments as the builder sees them: boxes, and "perfect splits" of long thin things, whose boxes say little about
// them. Coordinates are relative to an origin, subtracted in double and rounded to float once.
#pragma once

#include <vector>

#include "accel/leaf_blocks.h"
#include "accel/reference.h"
#include "core/segments.h"

namespace tress {

struct AxisSegment {
    Vec3 start;
    float start_radius;
    Vec3 end;
    float end_radius;
};
static_assert(sizeof(AxisSegment) == 32);

class SegmentPrimitives {
public:
    static constexpr uint32_t kRows = segment_row::kConstantRadius;

    SegmentPrimitives(const SegmentView& segments, const DVec3& origin);

    size_t size() const { return segments_.size(); }
    const AxisSegment& operator[](size_t id) const { return segments_[id]; }

    /// Box of everything within the radius of the axis, and some roundings more.
    Reference reference(uint32_t id) const;

    /// `part` is the box of a part of the segment, cut at s across `axis`: shrinks it to what lies below or above the
    /// plane; false where nothing does. What is within the radius of the axis and on this side belongs to axis points
    /// not farther than the radius on the other: the axis is clipped there, the box of what remains grown by the
    /// radius and cut with `part`.
    bool clip_below(Reference& part, uint32_t axis, float s) const { return clip(part, int(axis), s, 1); }
    bool clip_above(Reference& part, uint32_t axis, float s) const { return clip(part, int(axis), s, -1); }

private:
    bool clip(Reference& part, int axis, double s, double side) const;

    /// Added to a radius. Roundings of rays grow with the scene, not with the hair; but a scene with a far outlier must
    /// not swell thin hair to many times its width, so they count up to a share of the radius.
    double padding(const AxisSegment& segment, double radius) const;

    std::vector<AxisSegment> segments_;
    double scene_padding_ = 0;
};

}  // namespace tress
