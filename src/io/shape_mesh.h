// SPDX-License-Identifier: MIT
// The shapes a scene file may name instead of a mesh file, as triangles.
#pragma once

#include "core/mesh.h"
#include "core/scene_description.h"

namespace tress {

/// Two flat triangles; vertices are relative to the first corner, so that nothing is lost far from the origin.
TriangleMesh quad_mesh(const QuadShape& quad);

/// A sphere of the radius about the origin, with normals; its faces are nowhere off by more than 0.1 % of the radius.
TriangleMesh sphere_mesh(double radius);

}  // namespace tress
