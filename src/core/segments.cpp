// SPDX-License-Identifier: MIT
#include "core/segments.h"

namespace tress {
namespace {

bool is_valid(const StrandSet& s, uint32_t p) {
    return is_finite(s.point(p)) && std::isfinite(s.radius_at(p)) && s.radius_at(p) >= 0;
}

/// Shortest length whose direction is not lost to rounding (16 ulp) or to the fiber's own width.
double shortest_length(const Vec3& a, const Vec3& b, float radius) {
    const float largest = glm::max(max_component(abs(a)), max_component(abs(b)));
    const double ulps = 16.0 * std::numeric_limits<float>::epsilon() * double(largest);
    return glm::max(ulps, 1e-3 * double(radius));
}

}  // namespace

SegmentFate fate_of_segment(const StrandSet& strands, uint32_t p) {
    if (!is_valid(strands, p) || !is_valid(strands, p + 1)) return SegmentFate::dropped;
    const float radius = glm::max(strands.radius_at(p), strands.radius_at(p + 1));
    if (radius == 0) return SegmentFate::unseen;
    const Vec3 a = strands.point(p), b = strands.point(p + 1);
    const bool has_length = distance(DVec3(a), DVec3(b)) > shortest_length(a, b, radius);
    return has_length ? SegmentFate::kept : SegmentFate::dropped;
}

SegmentList list_segments(const StrandSet& strands) {
    SegmentList list;
    list.point.reserve(strands.points() - strands.strands());
    for (size_t strand = 0; strand < strands.strands(); ++strand) {
        for (uint32_t p = strands.first[strand]; p + 1 < strands.first[strand + 1]; ++p) {
            const SegmentFate fate = fate_of_segment(strands, p);
            if (fate == SegmentFate::kept) list.point.push_back(p);
            list.dropped += fate == SegmentFate::dropped;
        }
    }
    return list;
}

SegmentView view(const StrandSet& strands, const SegmentList& list) {
    SegmentView v;
    v.x = strands.x, v.y = strands.y, v.z = strands.z;
    v.radius = strands.radius;
    v.point = list.point;
    v.constant_radius = strands.constant_radius;
    return v;
}

bool joined(const SegmentView& v, uint32_t before, uint32_t after) {
    if (v.point[before] + 1 == v.point[after]) return true;
    const Vec3 a = v.end(before), b = v.start(after);
    return distance(DVec3(a), DVec3(b)) <= shortest_length(a, b, glm::max(v.end_radius(before), v.start_radius(after)));
}

SegmentRange own_strand(const SegmentView& v, uint32_t segment) {
    SegmentRange range{segment, segment};
    if (!v.linked) return range;
    const float reach = kOwnStrandRadii * glm::max(v.start_radius(segment), v.end_radius(segment));
    const auto span = [&](uint32_t s) { return distance(v.start(s), v.end(s)); };
    float away = 0;
    for (; range.first > 0 && away < reach && joined(v, range.first - 1, range.first); away += span(range.first))
        --range.first;
    away = 0;
    for (; range.last + 1 < v.size() && away < reach && joined(v, range.last, range.last + 1); away += span(range.last))
        ++range.last;
    return range;
}

Bounds bounds(const SegmentView& segments, const SegmentRange& range) {
    Bounds box;
    for (size_t s = range.first; s <= range.last; ++s) {
        const Vec3 r0(segments.start_radius(s)), r1(segments.end_radius(s));
        box.add(segments.start(s) - r0);
        box.add(segments.start(s) + r0);
        box.add(segments.end(s) - r1);
        box.add(segments.end(s) + r1);
    }
    return box;
}

Bounds bounds(const SegmentView& segments) {
    return segments.size() == 0 ? Bounds{} : bounds(segments, {0, uint32_t(segments.size() - 1)});
}

}  // namespace tress
