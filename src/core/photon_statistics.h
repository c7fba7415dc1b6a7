// SPDX-License-Identifier: MIT
// What became of the photons: figures of the tracing, for the reader of a render.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/path_type.h"

namespace tress {

/// Photons of one light.
struct LightPhotons {
    uint32_t light = 0;        // index in the scene
    uint64_t emitted = 0;      // drawn, those included that turn out to miss the scene
    uint64_t met_hair = 0;     // reached one fiber at least
    uint64_t on_polygons = 0;  // stored there, each arrival
    double power = 0;          // luminance, W: emitted towards the scene
};

/// Arrivals at fibers.
struct CrossingShare {
    uint64_t crossings = 0;
    double power = 0;  // luminance, W, with which they arrive
};

/// R events since light left a lamp or a surface that is not hair: 0, 1, or 2 and more.
inline constexpr int kReflectionClasses = 3;

struct PhotonStatistics {
    std::vector<LightPhotons> lights;  // empty: no photons were traced
    /// Of every fiber that a photon reaches, stored or not, by LightSource and R events.
    std::array<std::array<CrossingShare, kReflectionClasses>, 2> hair{};

    CrossingShare& hair_at(LightSource source, int reflections) {
        return hair[size_t(source)][size_t(std::min(reflections, kReflectionClasses - 1))];
    }
};

}  // namespace tress
