// SPDX-License-Identifier: MIT
// Where an object stands: an affine map in double, so that a scene far from the origin keeps its detail.
#pragma once

#include <array>
#include <cmath>

#include "core/math.h"

namespace tress {

/// Three rows of four numbers: point -> row . (x, y, z, 1).
struct Placement {
    std::array<double, 12> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

    DVec3 point(const DVec3& p) const { return vector(p) + DVec3(m[3], m[7], m[11]); }
    DVec3 vector(const DVec3& v) const {
        return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[4] * v.x + m[5] * v.y + m[6] * v.z,
                m[8] * v.x + m[9] * v.y + m[10] * v.z};
    }
    double determinant() const {
        return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
               m[2] * (m[4] * m[9] - m[5] * m[8]);
    }
    /// The factor by which lengths, and so radii, grow on average.
    double scale() const { return std::cbrt(std::abs(determinant())); }
};

}  // namespace tress
