// SPDX-License-Identifier: MIT
// a_k(theta): what a crossed fiber lets through under the straight-through model, kept as optical depth
// tau = -log a over the inclination. Depths add along a ray, so no order of crossings changes what they mean.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/fiber.h"

namespace tress {

/// Largest depth kept a crossing: exp(-50) is nothing, and sums stay finite.
inline constexpr float kOpaqueDepth = 50;

/// Where a number falls between the entries of a table: entry `first`, and how far on to the next.
struct TablePlace {
    int first;
    float fraction;
};

/// `position` in [0, 1] among `entries`; what is no number falls on the first.
inline TablePlace table_place(float position, int entries) {
    const float scaled = position > 0 ? position * float(entries - 1) : 0;
    const int first = glm::min(int(scaled), entries - 2);
    return {first, scaled - float(first)};
}

/// Rows are even in cos(theta): depth is smooth in it, while in sin(theta) it rises without bound near grazing.
inline TablePlace row_place(float abs_sin_theta, int rows) {
    return table_place(safe_sqrt(1 - abs_sin_theta * abs_sin_theta), rows);
}

/// Optical depth of a fiber of one absorption over its inclination, linear between rows.
struct AttenuationTable {
    static constexpr int kRows = 256;
    std::vector<Rgb> depth;  // kRows; row 0 is grazing

    Rgb at(float abs_sin_theta) const {
        const TablePlace row = row_place(abs_sin_theta, kRows);
        const Rgb* entry = &depth[size_t(row.first)];
        return entry[0] + row.fraction * (entry[1] - entry[0]);
    }
};
AttenuationTable make_attenuation_table(const Fiber& fiber);

/// Optical depth of one channel over inclination and absorption, bilinear: for strands with colours of their own.
struct AbsorptionTable {
    static constexpr int kRows = 128, kColumns = 128;
    std::vector<float> depth;  // kRows x kColumns; row 0 is grazing; column c is the absorption absorption_of(c)

    /// Columns are even in sigma_a / (1 + sigma_a); the last is infinite.
    static float absorption_of(int column);

    float at(float abs_sin_theta, float sigma_a) const {
        const TablePlace row = row_place(abs_sin_theta, kRows);
        const TablePlace column = table_place(1 - 1 / (1 + sigma_a), kColumns);
        const float* entry = &depth[size_t(row.first * kColumns + column.first)];
        const float low = entry[0] + column.fraction * (entry[1] - entry[0]);
        const float high = entry[kColumns] + column.fraction * (entry[kColumns + 1] - entry[kColumns]);
        return low + row.fraction * (high - low);
    }
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
