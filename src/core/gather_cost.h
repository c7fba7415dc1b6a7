// SPDX-License-Identifier: MIT
// What Type 2 will cost by rays and by projection, told from the scene and the options before anything is built: how
// `type2: auto` chooses.
#pragma once

#include <algorithm>
#include <bit>

#include "core/options.h"
#include "core/scene.h"

namespace tress {

/// Seconds of one core. Good to a factor of two or three: docs/projection.md has estimates beside what was measured.
struct GatherCost {
    double rays = 0;         // type 2 by gather.rays
    double projection = 0;   // by projection, and
    double build = 0;        // what must be made for it
    bool far_field = false;  // points share far hair: asked for, or estimated to pay
    int gap_points = 0;      // of hair, at which the gap is found

    bool projection_pays() const { return build + projection < rays; }
};

/// Cubes across the hair whose corners are probes: a power of two.
inline int probes_across(const ProjectionOptions& options, bool far_field) {
    return int(std::bit_ceil(unsigned(options.probes > 0 ? options.probes : far_field ? 128 : 64)));
}

/// As many as keep what they leave to chance, the same error in every pixel, small beside what the picture's samples of
/// hair leave; for a tenth of the time.
inline int gap_points(double samples) { return int(std::clamp(samples / 256, 256.0, 2048.0)); }
inline constexpr int kGapPointsOfPolygons = 4;  // one point of polygons for so many of hair

/// `detail` is not automatic. `skies`: environments that shine; `polygons`: whether light comes from polygons.
GatherCost estimate_gather_cost(const Scene& scene, const Options& options, ProjectionDetail detail, size_t skies,
                                bool polygons);

}  // namespace tress
