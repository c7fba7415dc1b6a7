// SPDX-License-Identifier: MIT
#include "gather/projection/viewpoints.h"

#include "core/rng.h"
#include "core/sampling.h"

namespace tress {
namespace {

/// `frame` turned about its z.
Frame spun(const Frame& frame, float turn) {
    const float c = std::cos(2 * kPi * turn), s = std::sin(2 * kPi * turn);
    return {c * frame.x + s * frame.y, c * frame.y - s * frame.x, frame.z};
}

}  // namespace

Frame turned_at_random(uint64_t key) {
    return spun(frame_about(sample_uniform_sphere({random(key, 1), random(key, 2)})), random(key, 0));
}

Viewpoint viewpoint_of(const ShadingPoint& point, uint64_t key) {
    if (point.fiber == kPolygon)
        return {point.position, spun(frame_about(point.geometric_normal), random(key, 0)), Dome::hemisphere, {}};
    return {point.position, turned_at_random(key), Dome::sphere, {}};
}

Unseen unseen_from(const ShadingPoint& point, const SegmentView& segments) {
    const SegmentRange own = point.excluded.segments;
    if (own.first > own.last) return {};
    return {own.first, own.last, bounds(segments, own)};
}

}  // namespace tress
