// SPDX-License-Identifier: MIT
// Places spread evenly over the cube [-1, 1]^3, in pairs about its middle: any even number of the first ones has its
// mean there. The first of each pair are of Roberts' additive sequence (2018, "The unreasonable effectiveness of
// quasirandom sequences"), whose generator is the real root of x^4 = x + 1.
#pragma once

#include <cstddef>

namespace tress {

inline constexpr size_t kMostSubSplats = 32;

struct CubePattern {
    alignas(64) float x[kMostSubSplats] = {};
    alignas(64) float y[kMostSubSplats] = {};
    alignas(64) float z[kMostSubSplats] = {};
};

constexpr CubePattern make_cube_pattern() {
    constexpr double root = 1.22074408460575947536;
    const double step[3] = {1 / root, 1 / (root * root), 1 / (root * root * root)};
    CubePattern pattern;
    float* const rows[3] = {pattern.x, pattern.y, pattern.z};
    for (int axis = 0; axis < 3; ++axis) {
        double place = 0.5;
        for (size_t i = 0; i < kMostSubSplats; i += 2) {
            place += step[axis];
            if (place >= 1) place -= 1;
            rows[axis][i] = float(2 * place - 1);
            rows[axis][i + 1] = -rows[axis][i];
        }
    }
    return pattern;
}

inline constexpr CubePattern kCubePattern = make_cube_pattern();

}  // namespace tress
