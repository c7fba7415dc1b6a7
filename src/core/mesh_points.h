// SPDX-License-Identifier: MIT
// Points spread evenly over the triangles of a mesh.
#pragma once

#include "core/mesh.h"

namespace tress {

/// Rows belong together by index.
struct MeshPoints {
    std::vector<Vec3> position;
    std::vector<Vec3> normal;  // geometric, unit, on the side that sees the corners counter-clockwise
};

/// About `n` of them: each triangle gets its share by area to within one, well spread over it. Triangles without an
/// area get none.
MeshPoints spread_points(const TriangleMesh& mesh, size_t n);

}  // namespace tress
