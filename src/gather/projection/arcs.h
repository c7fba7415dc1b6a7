// SPDX-License-Identifier: MIT
// A piece of a fiber as seen from a point. The fiber is the ribbon that rays meet (accel/segment_test-inl.h): the
// directions within the radius of its axis fill a lune between two half planes through the axis, of half angle
// asin(radius / distance of the axis), cut off where the ends are seen. With psi the inclination to the plane through
// the point across the axis, tan psi = s / (p cos phi) at the place s along the axis (from the foot of the
// perpendicular, of length p) and the angle phi about it, and the solid angle is cos psi dpsi dphi.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/aligned_array.h"
#include "core/math.h"

namespace tress {

/// Arcs of a PieceList, made ready. Rows belong together by index.
struct Arcs {
    AlignedArray<float> ux, uy, uz;   // unit, along the axis
    AlignedArray<float> nx, ny, nz;   // unit, from the point to the foot of the perpendicular
    AlignedArray<float> foot, along;  // length of the perpendicular; place of the start along the axis
    AlignedArray<float> length;
    AlignedArray<float> psi, step, steps;  // inclination of the start; of a step; their number
    AlignedArray<float> width;             // 2 asin(radius / foot), of the mean radius; pi inside the fiber
    AlignedArray<float> solid;             // width times 2 sin(step / 2): of a step, but for cos(psi)
    AlignedArray<float> taper;             // change of radius along the axis, over the mean radius

    explicit Arcs(size_t capacity) {
        for (auto* row :
             {&ux, &uy, &uz, &nx, &ny, &nz, &foot, &along, &length, &psi, &step, &steps, &width, &solid, &taper})
            *row = AlignedArray<float>(capacity);
    }
};

/// One arc to be drawn: steps i of inclination psi + (i + 1/2) step, about the foot that `normal` points to.
struct ArcRow {
    Vec3 axis, normal;
    float foot, along, length;
    float psi, step;
    size_t steps;
    float width, solid;   // as in Arcs
    float radius, taper;  // mean; change along the axis, over the mean
    int32_t first_opacity_row;
    uint32_t segment;  // that the arc is a part of
};

/// Near arcs in the order of segments and of places on them.
struct NearOrder {
    uint64_t key;
    uint32_t arc;

    NearOrder(const ArcRow& row, uint32_t index) : arc(index) {
        const uint32_t bits = std::bit_cast<uint32_t>(row.along);
        const uint32_t rising = bits >> 31 ? ~bits : bits | 0x80000000u;
        key = uint64_t(row.segment) << 32 | rising;
    }
    bool operator<(const NearOrder& o) const { return key != o.key ? key < o.key : arc < o.arc; }
};

}  // namespace tress
