// SPDX-License-Identifier: MIT
// What lies beyond the hair as seen from a place: polygons, their light, and where the sky is open. One ray a cell of
// an igloo, against polygons alone (Yuksel, Akleman & Keyser 2007, sec. 4.2).
#pragma once

#include <vector>

#include "core/frame.h"
#include "gather/projection/igloo.h"

namespace tress {

/// Rows belong together by the cell of a sphere.
struct LightProbe {
    Vec3 position{0};
    Frame frame;                                   // of the igloo
    std::vector<float> distance;                   // of the polygon seen in the cell; infinity: the sky
    std::vector<float> among_distance;             // the same where the polygon is among the hair; else infinity
    std::vector<Rgb> radiance;                     // of the polygon, towards the place
    std::vector<float> among_x, among_y, among_z;  // polygons among the hair, one after another, from the place; padded

    size_t bytes() const {
        return sizeof(LightProbe) + distance.size() * (2 * sizeof(float) + sizeof(Rgb)) +
               3 * among_x.size() * sizeof(float);
    }
};

/// The cell that sees what is seen from `place`, near the probe, along the unit vector `direction`: the polygon at
/// about the distance that the probe sees it at, from where the probe stands.
uint32_t cell_towards(const LightProbe& probe, const Igloo& igloo, const Vec3& place, const Vec3& direction);

}  // namespace tress
