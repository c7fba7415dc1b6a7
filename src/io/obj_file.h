// SPDX-License-Identifier: MIT
// Wavefront .obj: vertices, normals and polygons; everything else in the file is passed over.
// Parsed by tinyobjloader, after its words are checked so that messages name the line.
#pragma once

#include <string>

#include "core/mesh.h"

namespace tress {

/// Vertices that faces use, one for each pair of position and normal. Flat where any corner of the file has no normal.
TriangleMesh read_obj_file(const std::string& path);

}  // namespace tress
