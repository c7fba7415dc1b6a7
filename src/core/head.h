// SPDX-License-Identifier: MIT
// A simple mannequin bust, in cm: +y up, face towards +z, the origin in the middle of the head, which reaches from the
// chin at y = -11 to the crown at y = 11. It is a signed distance field of smoothly joined ellipsoids and cones.
#pragma once

#include "core/bounds.h"
#include "core/mesh.h"

namespace tress {

/// Negative inside. Near the surface a distance to within some per cent; further away only a measure that grows.
float head_distance(const Vec3& p);
/// Of the ears alone: hair does not grow on them.
float ear_distance(const Vec3& p);

/// Unit gradient of head_distance.
Vec3 head_normal(const Vec3& p);
/// The point of the surface near `p` (Newton steps along the gradient; for points within some cm).
Vec3 on_head(const Vec3& p);

/// Box of the bust, with some room about it.
Bounds head_bounds();

/// The bust as a closed mesh with normals: about 50 thousand triangles.
TriangleMesh make_head();

}  // namespace tress
