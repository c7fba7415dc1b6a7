// SPDX-License-Identifier: MIT
// What a node of a growing tree holds of a primitive: the box of the primitive's part in the node's cell.
// Cells and boxes are closed sets of floats: a cut at s leaves [lo, below(s)] to the left and [s, hi] to the right.
#pragma once

#include <bit>
#include <cstdint>

#include "core/bounds.h"

namespace tress {

struct Reference {
    Vec3 lo, hi;
    uint32_t id;
};
static_assert(sizeof(Reference) == 28);

/// The next larger float of a finite one.
inline float above(float x) {
    if (x == 0) return std::bit_cast<float>(1u);
    const uint32_t bits = std::bit_cast<uint32_t>(x);
    return std::bit_cast<float>(x > 0 ? bits + 1 : bits - 1);
}
inline float below(float x) { return -above(-x); }

inline Bounds left_cell(Bounds cell, uint32_t axis, float split) {
    cell.hi[int(axis)] = below(split);
    return cell;
}
inline Bounds right_cell(Bounds cell, uint32_t axis, float split) {
    cell.lo[int(axis)] = split;
    return cell;
}

/// Coordinates carry this many roundings from file to crossing (recentring, ray arithmetic, planes of the traversal);
/// boxes are wider than what they hold by as much, which also covers the rounding of boxes to float.
inline constexpr double kPadding = 8.0 * std::numeric_limits<float>::epsilon();

inline double largest_coordinate(const Vec3& p) { return max_component(abs(p)); }
inline double largest_coordinate(const Bounds& b) { return max_component(max(abs(b.lo), abs(b.hi))); }

}  // namespace tress
