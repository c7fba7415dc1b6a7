// SPDX-License-Identifier: MIT
// Low-discrepancy numbers: Owen-scrambled Sobol' points, a sequence of its own for every key (a pixel's), padded to any
// number of dimensions in groups of four whose indices are shuffled (Burley 2020, "Practical Hash-based Owen
// Scrambling"). Over indices [m 2^k, (m + 1) 2^k) every dimension has one value in each interval of length 2^-k, and
// the first two of a group form a (0, 2)-sequence: one point in every elementary box. Counter-based: a value depends on
// key, index and dimension alone.
#pragma once

#include <cstdint>

#include "core/math.h"

namespace tress {

inline constexpr uint32_t kSobolGroup = 4;  // dimensions

/// In [0, 1), 24 bits.
float sobol_sample(uint64_t key, uint32_t index, uint32_t dimension);

/// Dimensions first, first + 1 (and + 2, + 3), which must be of one group: they are well spread jointly.
Vec2 sobol_sample2(uint64_t key, uint32_t index, uint32_t first);
glm::vec4 sobol_sample4(uint64_t key, uint32_t index, uint32_t first);

/// Sample `index` of the sequence `key`.
struct Sampler {
    uint64_t key = 0;
    uint32_t index = 0;

    float get(uint32_t dimension) const { return sobol_sample(key, index, dimension); }
    Vec2 get2(uint32_t first) const { return sobol_sample2(key, index, first); }
    glm::vec4 get4(uint32_t first) const { return sobol_sample4(key, index, first); }
};

}  // namespace tress
