// SPDX-License-Identifier: MIT
// Segments as the builder sees them: boxes, and "perfect splits" of long thin things, whose boxes say little about
// them. Coordinates are relative to an origin, subtracted in double and rounded to float once.
#pragma once

#include <vector>

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
    SegmentPrimitives(const SegmentView& segments, const DVec3& origin);

    size_t size() const { return segments_.size(); }
    const AxisSegment& operator[](size_t id) const { return segments_[id]; }

    /// Box of everything within the radius of the axis, and some roundings more.
    Reference reference(uint32_t id) const;

    /// Shrinks the box to the part of the segment that lies in it; false where there is none. What is within the radius
    /// of the axis and in the box belongs to axis points in the box grown by the radius: the axis is clipped to that,
    /// the box of what remains grown by the radius, and cut with the old one.
    bool clip(Reference& reference) const;

private:
    /// Added to a radius. Roundings of rays grow with the scene, not with the hair; but a scene with a far outlier must
    /// not swell thin hair to many times its width, so they count up to a share of the radius.
    double padding(const AxisSegment& segment, double radius) const;

    std::vector<AxisSegment> segments_;
    double scene_padding_ = 0;
};

}  // namespace tress
