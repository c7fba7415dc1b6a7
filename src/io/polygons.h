// SPDX-License-Identifier: MIT
// What readers of mesh files share: polygons to triangles, and the last checks.
#pragma once

#include <span>
#include <string>

#include "core/mesh.h"

namespace tress {

/// Cuts a polygon of any size as a fan from its first corner; fewer than three corners make no triangle.
void add_polygon(TriangleMesh& mesh, std::span<const uint32_t> corners);

/// Makes normals unit; one without a direction becomes the mean of its triangles'. Throws InputError where there is
/// no triangle, or a vertex is not finite.
void finish_mesh(const std::string& path, TriangleMesh& mesh);

}  // namespace tress
