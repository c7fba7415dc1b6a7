// SPDX-License-Identifier: MIT
// Hair that is seen nearly alike from all places next to a corner of the probe grid: all but what is in a box of cubes
// about the corner, as seen from the corner itself. Places next to the corner project the hair of the box themselves,
// so that no hair counts twice, and none is lost; but a point's own fiber is left out only within the box. Drawing one
// of the eight corners about a place by its weight interpolates transmittance, not depth, over many points. The cells
// of a corner stand one way for all points.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "gather/projection/moment_tree.h"

namespace tress {

inline constexpr int kNearCubes = 2;  // of the grid, from a corner to the faces of its box

/// Optical depth as a fourth root of transmittance, ten bits a channel: transmittance is within 0.002. Depths beyond
/// kLargest become that.
struct PackedDepth {
    static constexpr float kLargest = 30;

    uint32_t bits = 0;
};

inline PackedDepth pack_depth(const Rgb& depth) {
    const auto part = [](float d) { return uint32_t(std::lround(1023 * std::exp(-0.25f * d))); };
    return {part(depth.r) | part(depth.g) << 10 | part(depth.b) << 20};
}

/// Depth of each value of a packed channel.
std::span<const float, 1024> unpacked_depths();

struct FarHair {
    std::vector<PackedDepth> depth;  // one a cell of the sphere; then, where there are polygons, of hair behind them
    MomentBox near_box;
    std::vector<MomentCube> near;  // those that have hair

    bool empty() const { return depth.empty(); }
    size_t bytes() const { return depth.size() * sizeof(PackedDepth) + near.size() * sizeof(MomentCube); }
};

}  // namespace tress
