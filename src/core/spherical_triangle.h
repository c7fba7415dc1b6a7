// SPDX-License-Identifier: MIT
// Triangles on the unit sphere, between arcs of great circles: their solid angle, and directions uniform over it.
// All of it stays accurate for triangles that are tiny, slivers, or nearly a hemisphere.
#pragma once

#include "core/math.h"

namespace tress {

struct SphericalTriangle {
    DVec3 pivot{0}, from{0}, to{0};  // unit
    double volume = 0;               // |det(pivot, from, to)|, of which rounded corners of a tiny triangle leave little
};

/// In [0, 2 pi]. tan of its half: volume / (1 + pivot.from + from.to + to.pivot) (Van Oosterom & Strackee 1983).
double solid_angle(const SphericalTriangle& triangle);

/// Sweeps an arc about `pivot`, from `from` to `to`, until it has passed over `part` of the triangle's solid angle; the
/// direction on that arc at `along` in [0, 1]. Uniform over the triangle if `part` and `along` are uniform (Arvo 1995,
/// "Stratified Sampling of Spherical Triangles").
DVec3 direction_in(const SphericalTriangle& triangle, double part, double along);

}  // namespace tress
