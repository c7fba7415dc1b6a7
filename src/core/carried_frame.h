// SPDX-License-Identifier: MIT
// A direction across a curve, carried along it without twist.
#pragma once

#include "core/frame.h"

namespace tress {

/// `side`, unit and across the unit vector `from`, after the smallest rotation that takes `from` to `to`.
inline Vec3 carry_side(const Vec3& side, const Vec3& from, const Vec3& to) {
    const float together = 1 + dot(from, to);
    // Where the curve turns right back the smallest rotation is not one: any side will do.
    if (!(together > 1e-3f)) return frame_about(to).x;
    const Vec3 carried = side - dot(side, to) / together * (from + to);
    const Vec3 across = carried - dot(carried, to) * to;  // what rounding has left
    return across / length(across);
}

}  // namespace tress
