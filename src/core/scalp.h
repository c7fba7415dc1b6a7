// SPDX-License-Identifier: MIT
// Where hair grows on the bust of head.h: the part of it above the hair line.
#pragma once

#include <cstdint>
#include <vector>

#include "core/head.h"
#include "core/scalar_grid.h"

namespace tress {

/// How thick the hair grows at a point of the head, 0 to 1: 0 below the hair line and on the ears.
float scalp_density(const Vec3& p);

/// What growing hair asks of the head, made ready.
struct Scalp {
    ScalarGrid field;          // head_distance, sampled
    std::vector<Vec3> corner;  // three a triangle: a coarse mesh of where hair grows
    std::vector<double> area;  // of the triangles up to and with each, times the density
};
Scalp make_scalp();

/// `count` points of the head with normals, spread evenly by area and density with one random point in each of `count`
/// shares of it.
struct Roots {
    std::vector<Vec3> point, normal;
};
Roots place_roots(const Scalp& scalp, size_t count, uint64_t key);

}  // namespace tress
