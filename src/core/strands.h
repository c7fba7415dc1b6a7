// SPDX-License-Identifier: MIT
// Strands of hair as arrays: polylines of points with a radius, and nothing that a scene does not need.
#pragma once

#include <cstdint>
#include <vector>

#include "core/math.h"

namespace tress {

/// Strand i owns the points first[i] .. first[i + 1] - 1, at least two. Absent arrays are empty.
struct StrandSet {
    std::vector<float> x, y, z;   // points, scene units
    std::vector<uint32_t> first;  // one a strand, and one past the end
    std::vector<float> radius;    // one a point, or empty: constant_radius everywhere
    std::vector<Rgb> color;       // one a point, or empty: the fiber's own colour
    float constant_radius = 0;    // 0: the source has none

    size_t points() const { return x.size(); }
    size_t strands() const { return first.empty() ? 0 : first.size() - 1; }
    Vec3 point(size_t i) const { return {x[i], y[i], z[i]}; }
    float radius_at(size_t i) const { return radius.empty() ? constant_radius : radius[i]; }

    void add_point(const Vec3& p) {
        x.push_back(p.x);
        y.push_back(p.y);
        z.push_back(p.z);
    }
};

/// Bytes held by the arrays.
inline size_t bytes(const StrandSet& s) {
    return (s.x.capacity() + s.y.capacity() + s.z.capacity() + s.radius.capacity()) * sizeof(float) +
           s.first.capacity() * sizeof(uint32_t) + s.color.capacity() * sizeof(Rgb);
}

}  // namespace tress
