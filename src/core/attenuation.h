// SPDX-License-Identifier: MIT
// a_k(theta): what a crossed fiber lets through under the straight-through model, kept as optical depth
// tau = -log a over |sin theta|. Depths add along a ray, so no order of crossings changes what they mean.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/fiber.h"

namespace tress {

/// Largest depth kept a crossing: exp(-50) is nothing, and sums stay finite.
inline constexpr float kOpaqueDepth = 50;

/// Optical depth of a fiber of one absorption, over |sin theta| in [0, 1], linear between rows.
struct AttenuationTable {
    static constexpr int kRows = 256;
    std::vector<Rgb> depth;  // kRows

    Rgb at(float abs_sin_theta) const;
};
AttenuationTable make_attenuation_table(const Fiber& fiber);

/// Optical depth of one channel over |sin theta| and absorption, bilinear: for strands with colours of their own.
struct AbsorptionTable {
    static constexpr int kRows = 128, kColumns = 128;
    std::vector<float> depth;  // kRows x kColumns; column c is the absorption absorption_of(c)

    float at(float abs_sin_theta, float sigma_a) const;
};
AbsorptionTable make_absorption_table(const Fiber& fiber);

/// The depth of every segment of a scene. Absent arrays are empty: one fiber, no colours.
struct Attenuation {
    std::vector<AttenuationTable> table;     // one a fiber; empty where sigma_a is not
    std::vector<AbsorptionTable> varying;    // one a fiber; empty where sigma_a is
    std::vector<uint16_t> fiber_of_segment;  // or empty: fiber 0
    std::vector<Rgb> sigma_a;                // one a segment, or empty: the fiber's own

    Rgb depth(uint32_t segment, float abs_sin_theta) const {
        const size_t fiber = fiber_of_segment.empty() ? 0 : fiber_of_segment[segment];
        if (sigma_a.empty()) return table[fiber].at(abs_sin_theta);
        const Rgb& sigma = sigma_a[segment];
        const AbsorptionTable& t = varying[fiber];
        return {t.at(abs_sin_theta, sigma.x), t.at(abs_sin_theta, sigma.y), t.at(abs_sin_theta, sigma.z)};
    }
};

}  // namespace tress
