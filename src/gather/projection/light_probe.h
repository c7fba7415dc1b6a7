// SPDX-License-Identifier: MIT
// What is seen from a place, and nearly alike from those next to it. Beyond the hair: polygons, their light, and where
// the sky is open, by one ray a cell of an igloo, against polygons alone (Yuksel, Akleman & Keyser 2007, sec. 4.2). And
// the hair that is not next to it.
#pragma once

#include <vector>

#include "core/frame.h"
#include "core/shared_exponent.h"
#include "gather/projection/far_hair.h"
#include "gather/projection/igloo.h"

namespace tress {

/// What a probe sees in one cell.
struct ProbeCell {
    float signed_distance = kInfinity;  // of the polygon; negative: it is among the hair; infinity: none, the sky
    SharedExponent radiance;            // of the polygon, towards the probe

    float distance() const { return std::abs(signed_distance); }
    bool is_sky() const { return signed_distance == kInfinity; }
    bool is_among_hair() const { return signed_distance < 0; }
};

struct LightProbe {
    Vec3 position{0};
    Frame frame;                   // of the igloos
    std::vector<ProbeCell> cells;  // of a sphere; empty: there are no polygons
    FarHair far;                   // empty: each point projects all hair

    size_t bytes() const { return sizeof(LightProbe) + cells.size() * sizeof(ProbeCell) + far.bytes(); }
};

/// The cell that sees what is seen from `place`, near the probe, along the unit vector `direction`: where that way is
/// as far from the probe as what the probe sees there, found step by step as by distance impostors (Szirmay-Kalos,
/// Aszodi, Lazanyi & Premecz 2005). Without a search, points look past polygons close by.
uint32_t cell_towards(const LightProbe& probe, const Igloo& igloo, const Vec3& place, const Vec3& direction);

}  // namespace tress
