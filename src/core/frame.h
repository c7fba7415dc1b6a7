// SPDX-License-Identifier: MIT
// An orthonormal, right-handed frame.
#pragma once

#include "core/math.h"

namespace tress {

struct Frame {
    Vec3 x, y, z;

    Vec3 to_local(const Vec3& v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
    Vec3 to_world(const Vec3& v) const { return v.x * x + v.y * y + v.z * z; }
};

/// Frame whose z is the unit vector `z`, without branches or singularities (Duff et al. 2017, listing 3).
inline Frame frame_about(const Vec3& z) {
    const float sign = std::copysign(1.0f, z.z);
    const float a = -1.0f / (sign + z.z);
    const float b = z.x * z.y * a;
    return {{1.0f + sign * z.x * z.x * a, sign * b, -sign * z.x}, {b, sign + z.y * z.y * a, -z.y}, z};
}

/// Frame of a fiber: x along the unit tangent, z as near to the unit vector `up` as it can be.
/// Any z will do where `up` is parallel to the tangent.
inline Frame fiber_frame(const Vec3& tangent, const Vec3& up) {
    const Vec3 side = cross(up, tangent);
    const float length2 = dot(side, side);
    if (!(length2 > 1e-12f)) {
        const Frame any = frame_about(tangent);
        return {tangent, any.x, any.y};
    }
    const Vec3 y = side / std::sqrt(length2);
    return {tangent, y, cross(tangent, y)};
}

}  // namespace tress
