// SPDX-License-Identifier: MIT
#include "io/shape_mesh.h"

#include <numbers>

namespace tress {
namespace {

// A step of angle a is off by 1 - cos(a / 2) across an edge, twice that within a face: 6e-4 here.
constexpr uint32_t kRows = 90, kColumns = 180;

}  // namespace

TriangleMesh quad_mesh(const QuadShape& quad) {
    TriangleMesh mesh;
    for (const DVec3& corner : quad.corner) mesh.add_vertex(Vec3(corner - quad.corner[0]));
    mesh.corner = {0, 1, 2, 0, 2, 3};
    return mesh;
}

TriangleMesh sphere_mesh(double radius) {
    TriangleMesh mesh;
    const auto add = [&](const DVec3& direction) {
        mesh.add_vertex(Vec3(radius * direction));
        mesh.normal.emplace_back(direction);
    };
    // Poles, then rows of vertices from +y to -y.
    add({0, 1, 0});
    add({0, -1, 0});
    for (uint32_t row = 1; row < kRows; ++row) {
        const double theta = std::numbers::pi * row / kRows;
        for (uint32_t column = 0; column < kColumns; ++column) {
            const double phi = 2 * std::numbers::pi * column / kColumns;
            add({std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)});
        }
    }
    const auto vertex = [](uint32_t row, uint32_t column) -> uint32_t {
        if (row == 0) return 0;
        if (row == kRows) return 1;
        return 2 + (row - 1) * kColumns + column % kColumns;
    };
    for (uint32_t row = 0; row < kRows; ++row) {
        for (uint32_t column = 0; column < kColumns; ++column) {
            const uint32_t a = vertex(row, column), b = vertex(row + 1, column);
            const uint32_t c = vertex(row + 1, column + 1), d = vertex(row, column + 1);
            if (row + 1 < kRows) mesh.corner.insert(mesh.corner.end(), {a, b, c});
            if (row > 0) mesh.corner.insert(mesh.corner.end(), {a, c, d});
        }
    }
    return mesh;
}

}  // namespace tress
