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

Viewpoint viewpoint_of(const ShadingPoint& point, uint64_t key) {
    const float turn = random(key, 0);
    if (point.fiber == kPolygon)
        return {point.position, spun(frame_about(point.geometric_normal), turn), Dome::hemisphere};
    const float u = random(key, 1), v = random(key, 2);
    return {point.position, spun(frame_about(sample_uniform_sphere({u, v})), turn), Dome::sphere};
}

}  // namespace tress
