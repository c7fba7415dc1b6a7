// SPDX-License-Identifier: MIT
// Maps from uniform numbers in [0, 1) to points and directions, each beside its density. Directions are unit, local to
// a frame whose z is the pole, and their densities are per steradian. All are continuous where the set allows it, so
// that well spread numbers stay well spread.
#pragma once

#include "core/math.h"

namespace tress {

/// Unit disc, by concentric squares (Shirley & Chiu 1997).
inline Vec2 sample_concentric_disc(const Vec2& u) {
    const Vec2 p = 2.0f * u - Vec2(1);
    if (p.x == 0 && p.y == 0) return p;
    const bool wide = std::abs(p.x) > std::abs(p.y);
    const float radius = wide ? p.x : p.y;
    const float angle = wide ? kPi / 4 * (p.y / p.x) : kPi / 2 - kPi / 4 * (p.x / p.y);
    return {radius * std::cos(angle), radius * std::sin(angle)};
}
inline float pdf_concentric_disc() { return kInvPi; }

/// Direction at height z = 1 - below and azimuth 2 pi turn; exact near the pole, where `below` is small.
inline Vec3 direction_below_pole(float below, float turn) {
    const float radius = safe_sqrt(below * (2 - below));
    const float azimuth = 2 * kPi * turn;
    return {radius * std::cos(azimuth), radius * std::sin(azimuth), 1 - below};
}

inline Vec3 sample_uniform_sphere(const Vec2& u) { return direction_below_pole(2 * u.x, u.y); }
inline float pdf_uniform_sphere() { return kInvPi / 4; }

inline Vec3 sample_uniform_hemisphere(const Vec2& u) { return direction_below_pole(u.x, u.y); }
inline float pdf_uniform_hemisphere() { return kInvPi / 2; }

/// Density proportional to the cosine to z (Malley's method).
inline Vec3 sample_cosine_hemisphere(const Vec2& u) {
    const Vec2 d = sample_concentric_disc(u);
    return {d.x, d.y, safe_sqrt(1 - d.x * d.x - d.y * d.y)};
}
inline float pdf_cosine_hemisphere(float cos_theta) { return cos_theta > 0 ? cos_theta * kInvPi : 0; }

/// Cone about z, uniform in solid angle. It is given by 1 - cos(half angle), which keeps narrow ones exact.
inline float one_minus_cos(float half_angle) { return 2 * square(std::sin(0.5f * half_angle)); }
inline Vec3 sample_cone(const Vec2& u, float one_minus_cos_max) {
    return direction_below_pole(u.x * one_minus_cos_max, u.y);
}
inline float pdf_cone(float one_minus_cos_max) { return 1 / (2 * kPi * one_minus_cos_max); }

/// Barycentric coordinates (of corners 1 and 2) uniform over a triangle.
inline Vec2 sample_triangle(const Vec2& u) {
    const float root = safe_sqrt(u.x);
    return {root * (1 - u.y), root * u.y};
}
/// Per area, of the triangle with edges a and b.
inline float pdf_triangle(const Vec3& a, const Vec3& b) { return 2 / glm::length(cross(a, b)); }
/// corner + u.x a + u.y b, uniform over its area.
inline Vec3 sample_parallelogram(const Vec2& u, const Vec3& corner, const Vec3& a, const Vec3& b) {
    return corner + u.x * a + u.y * b;
}
inline float pdf_parallelogram(const Vec3& a, const Vec3& b) { return 1 / glm::length(cross(a, b)); }

/// Offset in [-radius, radius] with the density of the four-term Blackman-Harris window (Harris 1978, "minimum
/// 4-term"): a pixel filter by importance sampling, one axis at a time. Increasing in u.
float sample_blackman_harris(float u, float radius);
float pdf_blackman_harris(float offset, float radius);

}  // namespace tress
