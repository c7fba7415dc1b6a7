// SPDX-License-Identifier: MIT
// Colours for pictures of differences: black, violet, red, orange, pale yellow, growing in lightness all the way.
#pragma once

#include <iterator>

#include "core/color_space.h"

namespace tress {

/// Display-linear colour of `value`, clamped to [0, 1]; what is not a number is 0.
inline Rgb heat_color(float value) {
    static constexpr float kPoints[][3] = {// sRGB encoded, evenly spaced over [0, 1]
                                           {0.00f, 0.00f, 0.02f}, {0.14f, 0.07f, 0.31f}, {0.37f, 0.10f, 0.48f},
                                           {0.60f, 0.18f, 0.50f}, {0.82f, 0.26f, 0.43f}, {0.96f, 0.44f, 0.36f},
                                           {1.00f, 0.68f, 0.44f}, {0.99f, 0.97f, 0.74f}};
    constexpr int kLast = int(std::size(kPoints)) - 1;
    const float position = (value > 0 ? std::min(value, 1.0f) : 0.0f) * kLast;
    const int i = std::min(int(position), kLast - 1);
    const float t = position - float(i);
    const auto channel = [&](int c) { return srgb_to_linear(kPoints[i][c] + t * (kPoints[i + 1][c] - kPoints[i][c])); };
    return {channel(0), channel(1), channel(2)};
}

}  // namespace tress
