// SPDX-License-Identifier: MIT
#include "accel/segment_primitives.h"

#include <tbb/parallel_for.h>

namespace tress {
namespace {

constexpr size_t kGrain = 16384;
constexpr double kPaddedShare = 1.0 / 8;  // of the radius

/// The interval of t in [0, 1] where start + t (end - start) lies in [lo, hi], cut with [t0, t1].
bool clip_axis(double start, double end, double lo, double hi, double& t0, double& t1) {
    if (start == end) return lo <= start && start <= hi;
    const double inverse = 1 / (end - start);
    const double a = (lo - start) * inverse, b = (hi - start) * inverse;
    t0 = std::max(t0, std::min(a, b));
    t1 = std::min(t1, std::max(a, b));
    return t0 <= t1;
}

}  // namespace

SegmentPrimitives::SegmentPrimitives(const SegmentView& segments, const DVec3& origin) : segments_(segments.size()) {
    tbb::parallel_for(tbb::blocked_range<size_t>(0, segments.size(), kGrain), [&](const auto& range) {
        for (size_t i = range.begin(); i < range.end(); ++i)
            segments_[i] = {Vec3(DVec3(segments.start(i)) - origin), segments.start_radius(i),
                            Vec3(DVec3(segments.end(i)) - origin), segments.end_radius(i)};
    });
    const Bounds box = bounds(segments);
    if (!segments_.empty())
        scene_padding_ = kPadding * largest_coordinate({Vec3(DVec3(box.lo) - origin), Vec3(DVec3(box.hi) - origin)});
}

double SegmentPrimitives::padding(const AxisSegment& s, double radius) const {
    const double own = kPadding * (std::max(largest_coordinate(s.start), largest_coordinate(s.end)) + radius);
    return std::max(own, std::min(scene_padding_, kPaddedShare * radius));
}

Reference SegmentPrimitives::reference(uint32_t id) const {
    const AxisSegment& s = segments_[id];
    const double pad = padding(s, std::max(s.start_radius, s.end_radius));
    const DVec3 start(s.start), end(s.end);
    const double r0 = s.start_radius + pad, r1 = s.end_radius + pad;
    return {Vec3(min(start - r0, end - r1)), Vec3(max(start + r0, end + r1)), id};
}

bool SegmentPrimitives::clip(Reference& reference) const {
    const AxisSegment& s = segments_[reference.id];
    const double radius = std::max(s.start_radius, s.end_radius), pad = padding(s, radius);
    const double grow = radius + pad;
    double t0 = 0, t1 = 1;
    for (int k = 0; k < 3; ++k)
        if (!clip_axis(s.start[k], s.end[k], reference.lo[k] - grow, reference.hi[k] + grow, t0, t1)) return false;
    const double r0 = s.start_radius, slope = double(s.end_radius) - r0;
    const double part_grow = r0 + std::max(t0 * slope, t1 * slope) + pad;
    for (int k = 0; k < 3; ++k) {
        const double start = s.start[k], length = s.end[k] - start;
        const double a = start + t0 * length, b = start + t1 * length;
        reference.lo[k] = std::max(reference.lo[k], float(std::min(a, b) - part_grow));
        reference.hi[k] = std::min(reference.hi[k], float(std::max(a, b) + part_grow));
        if (reference.lo[k] > reference.hi[k]) return false;
    }
    return true;
}

}  // namespace tress
