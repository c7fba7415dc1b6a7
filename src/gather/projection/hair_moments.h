// SPDX-License-Identifier: MIT
// Sums over pieces of hair: where it is, which way it runs, how much light it can stop, of what kind it is.
#pragma once

#include <cstdint>

#include "core/math.h"

namespace tress {

/// A part of a segment.
struct HairPiece {
    Vec3 a, b;
    float radius_a, radius_b;
    uint32_t segment;
};

struct HairMoments {
    double area = 0;            // sum of 2 r L
    DVec3 first{0}, second{0};  // of place, by area: means of x and of x^2 times area
    double tensor[6] = {};      // sum of 2 r L t t^T: xx, yy, zz, xy, xz, yz
    uint32_t sample = 0;        // a segment, drawn by area: what kind of hair it is

    void add(const HairPiece& piece);
    void add(const HairMoments& other);
};

/// Calls on_part(part, octant) for the parts of a piece on either side of the planes through `center`.
template <class OnPart>
void cut_at(const HairPiece& piece, const DVec3& center, const OnPart& on_part) {
    double at[5] = {0, 1, 1, 1, 1};
    int parts = 1;
    const DVec3 a(piece.a), b(piece.b);
    for (int axis = 0; axis < 3; ++axis) {
        const double from = a[axis] - center[axis], to = b[axis] - center[axis];
        if ((from < 0) == (to < 0) || from == to) continue;
        const double t = from / (from - to);
        int place = parts;  // insert t in order
        while (place > 1 && at[place - 1] > t) at[place] = at[place - 1], --place;
        at[place] = t;
        at[++parts] = 1;
    }
    for (int i = 0; i < parts; ++i) {
        if (!(at[i + 1] > at[i])) continue;
        const double t = 0.5 * (at[i] + at[i + 1]);
        const DVec3 middle = a + t * (b - a);
        const int octant = (middle.x >= center.x) | (middle.y >= center.y) << 1 | (middle.z >= center.z) << 2;
        const auto radius = [&](double s) {
            return float(glm::mix(double(piece.radius_a), double(piece.radius_b), s));
        };
        const bool whole = parts == 1;
        on_part(whole ? piece
                      : HairPiece{Vec3(a + at[i] * (b - a)), Vec3(a + at[i + 1] * (b - a)), radius(at[i]),
                                  radius(at[i + 1]), piece.segment},
                octant);
    }
}

}  // namespace tress
