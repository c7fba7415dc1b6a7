// SPDX-License-Identifier: MIT
// Vectors, constants and small numeric helpers used everywhere. Vectors are GLM's.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>

namespace tress {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using DVec3 = glm::dvec3;
using Rgb = glm::vec3;  // linear, Rec. 709 primaries

inline constexpr float kPi = 3.14159265358979323846f;
inline constexpr float kInvPi = 0.31830988618379067154f;
inline constexpr float kInfinity = std::numeric_limits<float>::infinity();

template <class T>
constexpr T square(T value) {
    return value * value;
}

/// sqrt of what rounding may have made slightly negative.
inline float safe_sqrt(float value) { return std::sqrt(value > 0 ? value : 0); }
inline double safe_sqrt(double value) { return std::sqrt(value > 0 ? value : 0); }

/// asin of what rounding may have pushed past 1.
inline float safe_asin(float value) { return std::asin(glm::clamp(value, -1.0f, 1.0f)); }

inline float max_component(const Vec3& v) { return glm::max(v.x, glm::max(v.y, v.z)); }
inline float min_component(const Vec3& v) { return glm::min(v.x, glm::min(v.y, v.z)); }
inline float mean(const Rgb& v) { return (v.x + v.y + v.z) * (1.0f / 3.0f); }
inline bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Relative luminance of linear Rec. 709 (ITU-R BT.709-6, item 3.2).
inline float luminance(const Rgb& v) { return 0.2126f * v.x + 0.7152f * v.y + 0.0722f * v.z; }

}  // namespace tress
