// SPDX-License-Identifier: MIT
#include "io/mesh_file.h"

#include "core/error.h"
#include "io/file_name.h"
#include "io/obj_file.h"
#include "io/ply_file.h"

namespace tress {

bool is_mesh_file_name(const std::string& path) {
    const std::string ending = file_ending(path);
    return ending == ".obj" || ending == ".ply";
}

TriangleMesh read_mesh_file(const std::string& path) {
    const std::string ending = file_ending(path);
    if (ending == ".obj") return read_obj_file(path);
    if (ending == ".ply") return read_ply_file(path);
    throw InputError(path, "unknown kind of mesh file, expected .obj or .ply");
}

}  // namespace tress
