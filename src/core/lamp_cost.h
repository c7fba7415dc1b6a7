// SPDX-License-Identifier: MIT
// What Type 1 will cost by shadow rays and by shadow maps, told from the scene and the options before anything is
// built: how `type1: auto` chooses.
#pragma once

#include <cstdint>
#include <span>

#include "core/options.h"
#include "core/scene.h"

namespace tress {

/// Seconds of one core. Good to a factor of two: docs/light.md has estimates beside what was measured.
struct LampCost {
    double rays = 0;   // shadow rays
    double build = 0;  // of shadow maps
    double maps = 0;   // asking them, with the rays next to each point
};

/// `lamps`: indices of lights. For samples on hair alone: polygons cost the same either way.
LampCost estimate_lamp_cost(const Scene& scene, const Options& options, std::span<const uint32_t> lamps);

}  // namespace tress
