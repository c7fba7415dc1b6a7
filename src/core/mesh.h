// SPDX-License-Identifier: MIT
// Triangles as arrays.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/math.h"

namespace tress {

/// Triangle t has corners corner[3 t] .. corner[3 t + 2], counter-clockwise seen from outside.
struct TriangleMesh {
    std::vector<float> x, y, z;     // vertices, scene units
    std::vector<Vec3> normal;       // unit, one a vertex, or empty: flat
    std::vector<uint32_t> corner;   // three a triangle
    std::vector<uint16_t> surface;  // one a triangle, or empty: all 0

    size_t vertices() const { return x.size(); }
    size_t triangles() const { return corner.size() / 3; }
    Vec3 vertex(size_t i) const { return {x[i], y[i], z[i]}; }
    std::array<Vec3, 3> triangle(size_t t) const {
        return {vertex(corner[3 * t]), vertex(corner[3 * t + 1]), vertex(corner[3 * t + 2])};
    }

    void add_vertex(const Vec3& p) {
        x.push_back(p.x);
        y.push_back(p.y);
        z.push_back(p.z);
    }
};

inline size_t bytes(const TriangleMesh& m) {
    return (m.x.capacity() + m.y.capacity() + m.z.capacity()) * sizeof(float) + m.normal.capacity() * sizeof(Vec3) +
           m.corner.capacity() * sizeof(uint32_t) + m.surface.capacity() * sizeof(uint16_t);
}

}  // namespace tress
