// SPDX-License-Identifier: MIT
// What Type 1 will cost by shadow rays and by deep shadow maps, told from the scene and the options before anything is
// built: how `type1: auto` chooses.
#pragma once

#include <cstdint>
#include <span>

#include "core/options.h"
#include "core/scene.h"

namespace tress {

/// Seconds of one core, of the stages that bear these names. Good to a factor of three: docs/light.md has estimates
/// beside what was measured.
struct LampCost {
    double rays = 0;   // Type 1 by shadow rays
    double maps = 0;   // Type 1 by deep shadow maps, and
    double build = 0;  // making them; 0 where type 3 has them made all the same

    bool maps_pay() const { return build + maps < rays; }
};

/// Points of a lamp that get a view of their own; a lamp among the hair has several views a point.
size_t view_count(const Light& light, int grid);

/// `lamps`: indices of lights. With a limit of time, of as many samples as shadow rays would allow.
LampCost estimate_lamp_cost(const Scene& scene, const Options& options, std::span<const uint32_t> lamps);

}  // namespace tress
