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
    /// `probe`: by which `seen` was found; null: light from among the hair is left out. The igloo is turned by `key`,
    /// or as that of the probe where it has far hair.
    Rgb operator()(const PreparedScene& prepared, const ShadingPoint& point, const LightProbe* probe,
                   std::span<const SeenLight> seen, uint64_t key, Isa isa);

    /// The same as last, with other shares of gaps.
    Rgb with_gaps(const PreparedScene& prepared, std::span<const SeenLight> seen, const GapShares& shares, Isa isa);

private:
    Rgb sum_of(const Igloo& igloo, std::span<const SeenLight> seen) const;

    Viewpoint from_;
    ProjectionScratch scratch_;
    CellLight cells_;
    std::vector<float> sight_;
};

}  // namespace tress
