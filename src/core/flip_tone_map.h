// SPDX-License-Identifier: MIT
// The tone mapper of HDR-FLIP: Narkowicz's fit of the ACES curve with its input scaled by 0.6 (Andersson et al. 2021).
// It is part of the measure; pictures for the eye are made by tone_map.h.
#pragma once

#include "core/math.h"

namespace tress::flip {

/// y = (a x^2 + b x) / (c x^2 + d x + e).
inline constexpr double kScale = 0.6;
inline constexpr double kA = 2.51 * kScale * kScale, kB = 0.03 * kScale;
inline constexpr double kC = 2.43 * kScale * kScale, kD = 0.59 * kScale, kE = 0.14;

/// Far past the point where the curve reaches 1: keeps squares finite.
inline constexpr float kBrightest = 1e4f;

inline float tone_map(float x) {
    x = glm::clamp(x, 0.0f, kBrightest);
    const float y = x * (float(kA) * x + float(kB)) / (x * (float(kC) * x + float(kD)) + float(kE));
    return glm::min(y, 1.0f);
}

/// The x >= 0 that the curve takes to y in (0, 1).
inline double inverse_tone_map(double y) {
    const double a = kA - y * kC, b = kB - y * kD, c = -y * kE;
    return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

}  // namespace tress::flip
