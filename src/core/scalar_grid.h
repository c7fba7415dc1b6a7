// SPDX-License-Identifier: MIT
// A scalar field sampled at the nodes of a regular grid: what a costly field is turned into before it is asked often.
#pragma once

#include <tbb/parallel_for.h>

#include <vector>

#include "core/bounds.h"

namespace tress {

struct ScalarGrid {
    Vec3 origin{0};  // of node (0, 0, 0)
    float cell = 1;  // distance of neighbouring nodes
    glm::ivec3 nodes{0};
    std::vector<float> value;  // x fastest

    size_t index(int i, int j, int k) const { return (size_t(k) * nodes.y + j) * nodes.x + i; }
    Vec3 node(int i, int j, int k) const { return origin + cell * Vec3(float(i), float(j), float(k)); }
};

/// `field(Vec3)` at every node of a grid over `box`; the last cells may reach past it.
template <class Field>
ScalarGrid sample_grid(const Field& field, const Bounds& box, float cell) {
    ScalarGrid grid;
    grid.origin = box.lo;
    grid.cell = cell;
    grid.nodes = glm::ivec3(glm::ceil(box.extent() / cell)) + 1;
    grid.value.resize(size_t(grid.nodes.x) * grid.nodes.y * grid.nodes.z);
    tbb::parallel_for(0, grid.nodes.z, [&](int k) {
        for (int j = 0; j < grid.nodes.y; ++j) {
            for (int i = 0; i < grid.nodes.x; ++i) grid.value[grid.index(i, j, k)] = field(grid.node(i, j, k));
        }
    });
    return grid;
}

struct GridValue {
    float value;
    Vec3 gradient;
};

/// Trilinear value and its gradient; outside the grid, those of the nearest point in it.
inline GridValue interpolate(const ScalarGrid& grid, const Vec3& p) {
    const Vec3 last = Vec3(grid.nodes - 1);
    const Vec3 at = glm::clamp((p - grid.origin) / grid.cell, Vec3(0), last);
    const glm::ivec3 c = glm::min(glm::ivec3(at), grid.nodes - 2);
    const Vec3 f = at - Vec3(c);
    const float* v = grid.value.data() + grid.index(c.x, c.y, c.z);
    const size_t dy = size_t(grid.nodes.x), dz = dy * grid.nodes.y;
    // Differences along x on the four edges of the cell, then their mixtures along y and z.
    const float x00 = v[1] - v[0], x10 = v[dy + 1] - v[dy], x01 = v[dz + 1] - v[dz];
    const float x11 = v[dz + dy + 1] - v[dz + dy];
    const float v00 = v[0] + f.x * x00, v10 = v[dy] + f.x * x10;
    const float v01 = v[dz] + f.x * x01, v11 = v[dz + dy] + f.x * x11;
    const float v0 = v00 + f.y * (v10 - v00), v1 = v01 + f.y * (v11 - v01);
    const float gx0 = x00 + f.y * (x10 - x00), gx1 = x01 + f.y * (x11 - x01);
    const Vec3 gradient(gx0 + f.z * (gx1 - gx0), (v10 - v00) + f.z * ((v11 - v01) - (v10 - v00)), v1 - v0);
    return {v0 + f.z * (v1 - v0), gradient / grid.cell};
}

}  // namespace tress
