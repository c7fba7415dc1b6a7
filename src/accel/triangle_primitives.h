// SPDX-License-Identifier: MIT
// Triangles as the builder sees them: boxes, and boxes of what remains of a triangle clipped to a box. Coordinates are
// relative to an origin, subtracted in double and rounded to float once.
#pragma once

#include <array>
#include <vector>

#include "accel/leaf_blocks.h"
#include "accel/reference.h"
#include "core/mesh.h"

namespace tress {

class TrianglePrimitives {
public:
    static constexpr uint32_t kRows = triangle_row::kRows;

    TrianglePrimitives(const TriangleMesh& mesh, const DVec3& origin);

    size_t size() const { return corners_.size(); }
    const std::array<Vec3, 3>& operator[](size_t id) const { return corners_[id]; }

    /// Box of the triangle, and some roundings more.
    Reference reference(uint32_t id) const;

    /// `part` is the box of a part of the triangle, cut at a plane: shrinks it to the box of what lies in it; false
    /// where nothing does.
    bool clip_below(Reference& part, uint32_t, float) const { return clip(part); }
    bool clip_above(Reference& part, uint32_t, float) const { return clip(part); }

private:
    bool clip(Reference& part) const;

    std::vector<std::array<Vec3, 3>> corners_;
    double padding_ = 0;  // roundings of the scene's largest coordinate
};

}  // namespace tress
