// SPDX-License-Identifier: MIT
// Random numbers with a sign, and smooth noise along a line.
#pragma once

#include "core/math.h"
#include "core/rng.h"

namespace tress {

/// Uniform in [-1, 1).
constexpr float signed_random(uint64_t key, uint64_t index) { return 2 * random(key, index) - 1; }

/// Smooth in t, in (-1, 1), with one independent value at each integer t >= 0.
inline float line_noise(uint64_t key, float t) {
    const float cell = std::floor(t);
    const float f = t - cell, blend = f * f * (3 - 2 * f);
    const float a = signed_random(key, uint64_t(cell)), b = signed_random(key, uint64_t(cell) + 1);
    return a + blend * (b - a);
}

/// Three independent line noises.
inline Vec3 line_noise3(uint64_t key, float t) {
    return {line_noise(hash(key, 0), t), line_noise(hash(key, 1), t), line_noise(hash(key, 2), t)};
}

}  // namespace tress
