// SPDX-License-Identifier: MIT
// Where probes stand: at the corners of a grid of cubes over the hair.
#pragma once

#include <cstdint>

#include "gather/projection/hair_cube.h"

namespace tress {

struct ProbeGrid {
    Vec3 origin{0};
    float size = 1;  // of the cubes
};

/// `across`: at least so many cubes along the side of the cube about the hair, which is halved until they are enough.
ProbeGrid make_probe_grid(const HairCube& hair, int across);

/// The cube that a place is in.
struct ProbeCube {
    ProbeGrid grid;
    int32_t x, y, z;  // of the low corner, in cubes from the origin
    Vec3 place;       // in the cube, [0, 1]

    /// Of corners 0 to 7, one bit an axis; to the bit the same in all cubes that share it.
    Vec3 corner(int i) const {
        return grid.origin + grid.size * Vec3(float(x + (i & 1)), float(y + (i >> 1 & 1)), float(z + (i >> 2)));
    }
    /// Of the corner, the same in all cubes that share it.
    uint64_t key(int i) const;
    /// Of trilinear interpolation at the place.
    float weight(int i) const;
};

/// `place`: within the bounds of the hair.
ProbeCube cube_at(const ProbeGrid& grid, const Vec3& place);

}  // namespace tress
