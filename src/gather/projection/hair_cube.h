// SPDX-License-Identifier: MIT
// The cube about all hair that is divided into smaller ones, for the tree of moments and the grid of probes alike.
#pragma once

#include "core/bounds.h"

namespace tress {

struct HairCube {
    Vec3 center{0};
    float half = 0;  // of its side
};

/// A little larger than `hair`, and not about its middle: planes of cubes are not on polygons at round numbers.
inline HairCube hair_cube(const Bounds& hair) {
    const float longest = max_component(hair.extent());
    return {hair.center() + longest * Vec3(0.0037f, 0.0059f, 0.0083f), 0.51f * longest};
}

}  // namespace tress
