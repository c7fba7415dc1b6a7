// SPDX-License-Identifier: MIT
// The line along which a hair lies: it leaves the scalp, is combed, falls, and slides along the head and shoulders.
#pragma once

#include <array>

#include "core/groom_style.h"
#include "core/scalp.h"

namespace tress {

struct HairPath {
    static constexpr int kNodes = 64;
    std::array<Vec3, kNodes> node;  // `step` apart, the first at the root
    float step = 0;

    float length() const { return step * (kNodes - 1); }
    /// The point at arc length s, clamped to the path.
    Vec3 at(float s) const;
};

/// How one hair differs from its neighbours.
struct HairCharacter {
    uint64_t key = 0;
    float layer = 0.5f;  // how high it lies in the hair: 0 on the skin, 1 on top
    float unruly = 0;    // 0: as its neighbours; 1: a flyaway
};

/// 0 at the lowest part of the hair line, 1 at the crown.
float root_height(const Vec3& root);

/// The longest strand that the style has, with what variation may add.
float longest_strand(const GroomStyle& style);

/// 1 where the hair falls to the left and right of the parting, fading to 0 behind its end.
float parting_strength(const GroomStyle& style, const Vec3& root);
/// -1 to the right of the parting (-x), 1 to the left.
float parting_side(const GroomStyle& style, const Vec3& root);

HairPath grow_path(const GroomStyle& style, const Scalp& scalp, const Vec3& root, const Vec3& normal,
                   const HairCharacter& character);

/// `p` moved out of the head where it lies less than `clearance` outside.
Vec3 push_out(const Scalp& scalp, const Vec3& p, float clearance);

}  // namespace tress
