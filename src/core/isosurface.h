// SPDX-License-Identifier: MIT
// The surface on which a sampled field is zero, as triangles: surface nets (Gibson 1998), one vertex a cell that the
// surface passes, at the mean of the crossings of the cell's edges. The field is negative inside. The mesh is closed
// where the field is positive on the whole border of the grid, and two-manifold where the surface is smooth at the
// scale of a cell.
#pragma once

#include <limits>

#include "core/mesh.h"
#include "core/scalar_grid.h"

namespace tress {

class SurfaceNet {
public:
    explicit SurfaceNet(const ScalarGrid& grid) : grid_(grid), vertex_(grid.value.size(), kNone) {}

    TriangleMesh build() {
        for_cells([&](int i, int j, int k) { place_vertex(i, j, k); });
        for_cells([&](int i, int j, int k) { join_cells(i, j, k); });
        return std::move(mesh_);
    }

private:
    static constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();

    template <class Visit>
    void for_cells(const Visit& visit) const {
        for (int k = 0; k + 1 < grid_.nodes.z; ++k) {
            for (int j = 0; j + 1 < grid_.nodes.y; ++j) {
                for (int i = 0; i + 1 < grid_.nodes.x; ++i) visit(i, j, k);
            }
        }
    }

    float value(const glm::ivec3& n) const { return grid_.value[grid_.index(n.x, n.y, n.z)]; }
    bool inside(const glm::ivec3& n) const { return value(n) < 0; }
    static glm::ivec3 corner(int number) { return {number & 1, (number >> 1) & 1, number >> 2}; }

    void place_vertex(int i, int j, int k) {
        const glm::ivec3 cell(i, j, k);
        Vec3 sum(0);
        int crossings = 0;
        for (int a = 0; a < 8; ++a) {
            for (int axis = 1; axis < 8; axis <<= 1) {
                if (a & axis) continue;
                const glm::ivec3 from = cell + corner(a), to = cell + corner(a | axis);
                if (inside(from) == inside(to)) continue;
                const float t = value(from) / (value(from) - value(to));
                sum += Vec3(from) + t * Vec3(to - from);
                ++crossings;
            }
        }
        if (!crossings) return;
        vertex_[grid_.index(i, j, k)] = uint32_t(mesh_.vertices());
        mesh_.add_vertex(grid_.origin + grid_.cell * sum / float(crossings));
    }

    /// Every crossed edge of the grid that starts at node (i, j, k) becomes a quad between the four cells about it.
    void join_cells(int i, int j, int k) {
        const glm::ivec3 node(i, j, k);
        for (int axis = 0; axis < 3; ++axis) {
            glm::ivec3 along(0), side(0), up(0);
            along[axis] = side[(axis + 1) % 3] = up[(axis + 2) % 3] = 1;
            if (node[(axis + 1) % 3] == 0 || node[(axis + 2) % 3] == 0) continue;
            if (inside(node) == inside(node + along)) continue;
            const uint32_t quad[4] = {cell_vertex(node - side - up), cell_vertex(node - up), cell_vertex(node),
                                      cell_vertex(node - side)};
            // Seen from the end of the edge the quad runs counter-clockwise: right where the field grows along it.
            if (inside(node)) {
                add_quad(quad[0], quad[1], quad[2], quad[3]);
            } else {
                add_quad(quad[3], quad[2], quad[1], quad[0]);
            }
        }
    }

    uint32_t cell_vertex(const glm::ivec3& cell) const { return vertex_[grid_.index(cell.x, cell.y, cell.z)]; }

    /// Cut along the shorter diagonal.
    void add_quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
        const bool through_a = distance(mesh_.vertex(a), mesh_.vertex(c)) <= distance(mesh_.vertex(b), mesh_.vertex(d));
        if (through_a) {
            mesh_.corner.insert(mesh_.corner.end(), {a, b, c, a, c, d});
        } else {
            mesh_.corner.insert(mesh_.corner.end(), {b, c, d, b, d, a});
        }
    }

    const ScalarGrid& grid_;
    std::vector<uint32_t> vertex_;  // of the cell that starts at the node, or kNone
    TriangleMesh mesh_;
};

inline TriangleMesh isosurface(const ScalarGrid& grid) { return SurfaceNet(grid).build(); }

}  // namespace tress
