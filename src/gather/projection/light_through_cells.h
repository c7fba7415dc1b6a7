// SPDX-License-Identifier: MIT
// What of the light that a point may receive comes through the cells about it.
#pragma once

#include <span>
#include <vector>

#include "gather/prepared_scene.h"
#include "gather/projection/seen_light.h"

namespace tress {

class LightThroughCells {
public:
    LightThroughCells() = default;
    LightThroughCells(const LightThroughCells&) = delete;
    LightThroughCells& operator=(const LightThroughCells&) = delete;

    /// `probe`: by which the light was found; null: light from among the hair is left out. The igloo is turned by
    /// `key`, or as that of the probe where it has far hair.
    void project(const PreparedScene& prepared, const ShadingPoint& point, const LightProbe* probe, uint64_t key,
                 Isa isa);

    /// Of `seen` from the point that was projected last.
    Rgb light(const PreparedScene& prepared, std::span<const SeenLight> seen, const GapShares& shares, Isa isa);

private:
    ProjectionScratch scratch_;
    CellLight cells_;
    std::vector<float> sight_;
    Viewpoint from_;  // refers to sight_
};

}  // namespace tress
