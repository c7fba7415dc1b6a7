// SPDX-License-Identifier: MIT
// Directions and offsets to the exact ends of their ranges, and past them by a rounding, tried on a fiber.
#pragma once

#include <vector>

#include "tools/check/support/fiber_quadrature.h"

namespace tress {

inline constexpr float kOffsetEnds[] = {-1.0000001f, -1, -0.99999994f, -0.5f, 0, 0.7f, 0.9999f, 1, 1.0000001f};

/// The far field model does not read the offset: one will do.
inline std::span<const float> offset_ends(FiberModel model) {
    return model == FiberModel::chiang ? std::span<const float>(kOffsetEnds) : std::span(kOffsetEnds).first(1);
}

/// At inclinations from pole to pole, all round, and the poles themselves, as long as 1 to a rounding.
inline std::vector<Vec3> extreme_directions() {
    constexpr int kAzimuths = 8;
    constexpr double kInclinations[] = {-kPiD / 2, -1.5707, -1.5, -0.8, -1e-4, 0, 0.3, 1.2, 1.57, 1.570796, kPiD / 2};
    std::vector<Vec3> directions;
    for (const double theta : kInclinations)
        for (int k = 0; k < kAzimuths; ++k)
            directions.push_back(direction(theta, (k - kAzimuths / 2) * 2 * kPiD / kAzimuths));
    for (const float length : {0.99999994f, 1.0f, 1.0000001f})
        for (const float sign : {-1.0f, 1.0f}) directions.push_back(Vec3(sign * length, 0, 0));
    return directions;
}

/// How many values were asked for, and how many of them were negative, infinite or no number; of directions drawn, not
/// unit either.
struct Soundness {
    uint64_t tried = 0, unsound = 0;
};

inline bool is_sound(const FiberScattering& value) {
    return is_finite(value.forward) && is_finite(value.reflected) && min_component(value.forward) >= 0 &&
           min_component(value.reflected) >= 0;
}

inline bool is_sound(const FiberSample& s) {
    return is_finite(s.wi) && std::abs(length(s.wi) - 1) < 1e-5f && std::isfinite(s.pdf) && s.pdf >= 0 &&
           is_sound(s.value);
}

/// From each of `directions` to every other at the ends of the offset, and directions drawn with numbers at their ends.
inline void try_all(const Fiber& fiber, const std::vector<Vec3>& directions, Soundness& sum) {
    const Rgb& sigma_a = fiber.parameters.sigma_a;
    std::vector<FiberScattering> value(directions.size());
    for (const Vec3& wo : directions)
        for (const float h : offset_ends(fiber.parameters.model)) {
            evaluate(fiber, sigma_a, wo, h, directions, value);
            for (const FiberScattering& v : value) sum.unsound += !is_sound(v);
            constexpr float kHighest = 1 - 0x1p-24f;
            for (const float x : {0.0f, 0.5f, kHighest})
                sum.unsound += !is_sound(sample(fiber, sigma_a, wo, h, {x, kHighest - x, x, kHighest}));
            sum.tried += value.size() + 3;
        }
}

/// Fibers of both models, rough and smooth, of glass that bends much, little or not at all, that tilt their scales or
/// do not, clear and black.
inline Soundness try_all_extremes() {
    const std::vector<Vec3> directions = extreme_directions();
    Soundness sum;
    for (const FiberModel model : {FiberModel::chiang, FiberModel::marschner})
        for (const float beta : {0.0f, 0.3f, 1.0f})
            for (const float eta : {1.0f, 1.0000001f, 1.55f, 10.0f})
                for (const float alpha : {0.0f, 40.0f})
                    for (const float sigma_a : {0.0f, 1.0f, kInfinity})
                        try_all(make_fiber({model, Rgb(sigma_a), beta, beta, alpha, eta}), directions, sum);
    return sum;
}

}  // namespace tress
