// SPDX-License-Identifier: MIT
// A mesh from a file of any kind that is known, by the ending of its name: .obj, .ply.
#pragma once

#include <string>

#include "core/mesh.h"

namespace tress {

/// Whether the name of the file ends as a mesh file's does.
bool is_mesh_file_name(const std::string& path);

TriangleMesh read_mesh_file(const std::string& path);

}  // namespace tress
