// SPDX-License-Identifier: MIT
// The azimuthal lobe: a logistic cut to [-pi, pi] and normalised there (Chiang et al. 2016).
#pragma once

#include <numbers>

#include "core/math.h"

namespace tress {

/// Smallest scale kept: a lobe 2e-4 radians wide, hundreds of roundings of an azimuth near pi.
inline constexpr double kSmallestScale = 1e-4;

struct AzimuthalLobe {
    float scale = 1;          // s
    float inverse = 1;        // 1 / s
    float normalization = 1;  // 1 / (s tanh(pi / (2 s)))
    float tail = 0;           // what the uncut logistic has below -pi: 1 / (1 + exp(pi / s))
};

inline AzimuthalLobe make_azimuthal(double scale) {
    const double s = scale > kSmallestScale ? scale : kSmallestScale;
    const double pi = std::numbers::pi;
    return {float(s), float(1 / s), float(1 / (s * std::tanh(pi / (2 * s)))), float(1 / (1 + std::exp(pi / s)))};
}

/// An angle within [-2 pi, 2 pi] brought into [-pi, pi].
inline float wrap_angle(float angle) {
    if (angle > kPi) return angle - 2 * kPi;
    if (angle < -kPi) return angle + 2 * kPi;
    return angle;
}

/// Density at `angle` from the middle of the lobe, which lies in [-pi, pi].
inline float azimuthal(const AzimuthalLobe& lobe, float angle) {
    const float fall = std::exp(-std::abs(angle) * lobe.inverse);
    return fall * lobe.normalization / square(1 + fall);
}

inline float sample_azimuthal(const AzimuthalLobe& lobe, float u) {
    constexpr float kLowest = 0x1p-26f;  // finer than u: keeps the logarithm finite where the tail is nothing
    const float half = u < 0.5f ? u : 1 - u;
    const float below = glm::max(lobe.tail + half * (1 - 2 * lobe.tail), kLowest);
    const float distance = glm::clamp(lobe.scale * std::log((1 - below) / below), 0.0f, kPi);
    return u < 0.5f ? -distance : distance;
}

}  // namespace tress
