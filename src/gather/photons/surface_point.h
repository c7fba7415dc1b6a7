// SPDX-License-Identifier: MIT
// Whether two points lie on one smooth piece of surface: what estimates of irradiance may mix.
#pragma once

#include "core/math.h"

namespace tress {

/// A point on a side of a polygon.
struct SurfacePoint {
    Vec3 position, normal;  // normal: geometric, unit, on that side
    float rounding;         // of `position`, and of what is compared with it
};

inline SurfacePoint surface_point(const Vec3& position, const Vec3& normal) {
    constexpr float ulps = 64 * std::numeric_limits<float>::epsilon();
    return {position, normal, ulps * max_component(abs(position))};
}

/// The normals must agree, and the chord must be nearly perpendicular to their sum, which on planes, spheres and
/// cylinders it is exactly: the other side of a thin thing, a parallel surface and a wall that meets this one are other
/// surfaces. `chord` leads from `a` to a point `distance` away with the normal `normal`.
inline bool on_same_surface(const SurfacePoint& a, const Vec3& chord, float distance, const Vec3& normal) {
    constexpr float kLeastCosine = 0.7f, kMostSlope = 0.3f;
    return dot(a.normal, normal) > kLeastCosine &&
           std::abs(dot(chord, a.normal + normal)) <= kMostSlope * distance + a.rounding;
}

/// Farthest from the tangent plane of a point on the same surface, in distances: half a turn of acos(kLeastCosine),
/// and what kMostSlope adds to it.
inline constexpr float kMostRise = 0.6f;

}  // namespace tress
