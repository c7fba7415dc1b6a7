// SPDX-License-Identifier: MIT
// The .ply format (Turk 1994), as text and as bytes of either order: vertices with or without normals, polygons of any
// size. Other elements and properties are passed over.
#pragma once

#include <string>

#include "core/mesh.h"

namespace tress {

TriangleMesh read_ply_file(const std::string& path);

}  // namespace tress
