// SPDX-License-Identifier: MIT
#include "accel/segment_primitives.h"

#include <tbb/parallel_for.h>

namespace tress {
namespace {

constexpr size_t kGrain = 16384;
constexpr double kPaddedShare = 1.0 / 8;  // of the radius

}  // namespace

SegmentPrimitives::SegmentPrimitives(const SegmentView& segments, const DVec3& origin) : segments_(segments.size()) {
    tbb::parallel_for(tbb::blocked_range<size_t>(0, segments.size(), kGrain), [&](const auto& range) {
        for (size_t i = range.begin(); i < range.end(); ++i)
            segments_[i] = {Vec3(DVec3(segments.start(i)) - origin), segments.start_radius(i),
                            Vec3(DVec3(segments.end(i)) - origin), segments.end_radius(i)};
    });
    double largest = 0;
    for (const AxisSegment& s : segments_)
        largest =
            std::max({largest, largest_coordinate(s.start) + s.start_radius, largest_coordinate(s.end) + s.end_radius});
    scene_padding_ = kPadding * largest;
}

double SegmentPrimitives::padding(const AxisSegment& s, double radius) const {
    if (scene_padding_ <= kPaddedShare * radius) return scene_padding_;
    const double own = kPadding * (std::max(largest_coordinate(s.start), largest_coordinate(s.end)) + radius);
    return std::max(own, kPaddedShare * radius);
}

Reference SegmentPrimitives::reference(uint32_t id) const {
    const AxisSegment& s = segments_[id];
    const double pad = padding(s, std::max(s.start_radius, s.end_radius));
    const DVec3 start(s.start), end(s.end);
    const double r0 = s.start_radius + pad, r1 = s.end_radius + pad;
    return {Vec3(min(start - r0, end - r1)), Vec3(max(start + r0, end + r1)), id};
}

bool SegmentPrimitives::clip(Reference& part, int axis, double s, double side) const {
    const AxisSegment& segment = segments_[part.id];
    const double r0 = segment.start_radius, r1 = segment.end_radius, radius = std::max(r0, r1);
    const double pad = padding(segment, radius);
    // Start and end as heights above the plane, measured away from the side that is kept.
    const double limit = radius + pad;
    const double start = side * (segment.start[axis] - s), end = side * (segment.end[axis] - s);
    if (start > limit && end > limit) return false;
    double t0 = 0, t1 = 1;
    if (start > limit) t0 = (limit - start) / (end - start);
    if (end > limit) t1 = (limit - start) / (end - start);
    const double grow = r0 + (r1 - r0) * (r1 > r0 ? t1 : t0) + pad;
    for (int k = 0; k < 3; ++k) {
        const double origin = segment.start[k], length = segment.end[k] - origin;
        const double a = origin + t0 * length, b = origin + t1 * length;
        part.lo[k] = std::max(part.lo[k], float(std::min(a, b) - grow));
        part.hi[k] = std::min(part.hi[k], float(std::max(a, b) + grow));
    }
    return part.lo.x <= part.hi.x && part.lo.y <= part.hi.y && part.lo.z <= part.hi.z;
}

}  // namespace tress
