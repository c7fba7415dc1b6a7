// SPDX-License-Identifier: MIT
// Pieces of hair next to a point, to be drawn exactly.
#pragma once

#include "core/aligned_array.h"
#include "core/math.h"

namespace tress {

/// Rows belong together by index; kPadding rows past `size` may be read.
struct PieceList {
    static constexpr size_t kCapacity = 512, kPadding = 16;

    AlignedArray<float> ax, ay, az, bx, by, bz;  // ends, relative to the point
    AlignedArray<float> start_radius, end_radius;
    AlignedArray<float> rounding;    // of the ends, along an axis
    AlignedArray<int32_t> kind;      // of HairOpacity
    AlignedArray<uint32_t> segment;  // that it is a part of
    size_t size = 0;

    PieceList() : kind(kCapacity + kPadding), segment(kCapacity + kPadding) {
        for (auto* row : {&ax, &ay, &az, &bx, &by, &bz, &start_radius, &end_radius, &rounding})
            *row = AlignedArray<float>(kCapacity + kPadding);
    }

    bool full() const { return size == kCapacity; }
    void add(const Vec3& a, const Vec3& b, float radius_a, float radius_b, float rounded, uint32_t of_kind,
             uint32_t of_segment) {
        ax[size] = a.x, ay[size] = a.y, az[size] = a.z;
        bx[size] = b.x, by[size] = b.y, bz[size] = b.z;
        start_radius[size] = radius_a, end_radius[size] = radius_b;
        rounding[size] = rounded;
        kind[size] = int32_t(of_kind);
        segment[size] = of_segment;
        ++size;
    }
};

}  // namespace tress
