// SPDX-License-Identifier: MIT
// Where a ray is inside a box.
#pragma once

#include <algorithm>

#include "core/bounds.h"

namespace tress {

/// [enter, exit], in lengths of the direction; empty, enter > exit, where the ray misses the box.
struct BoxPassage {
    float enter = 0, exit = kInfinity;

    bool holds(float t) const { return enter <= t && t <= exit; }
};

inline BoxPassage passage(const Bounds& box, const Vec3& origin, const Vec3& direction) {
    BoxPassage p;
    for (int axis = 0; axis < 3; ++axis) {
        const float inverse = 1 / direction[axis];
        const float a = (box.lo[axis] - origin[axis]) * inverse, b = (box.hi[axis] - origin[axis]) * inverse;
        p.enter = std::max(p.enter, std::min(a, b));
        p.exit = std::min(p.exit, std::max(a, b));
    }
    return p;
}

}  // namespace tress
