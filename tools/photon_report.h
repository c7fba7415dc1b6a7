// SPDX-License-Identifier: MIT
// What became of the photons, in words and as --stats writes it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/photon_statistics.h"
#include "core/scene.h"

namespace tress {

/// Percent of the power that arrives at fibers, by source of the light and number of R events (0, 1, 2 and more);
/// all 0 where none arrives.
struct HairShares {
    std::array<double, kReflectionClasses> from_lamps{}, from_elsewhere{};
};
HairShares hair_shares(const PhotonStatistics& statistics);

/// A line each: how much of the light in hair was reflected how often, and lights whose photons never met hair.
/// Nothing where no photons were traced.
std::vector<std::string> photon_lines(const PhotonStatistics& statistics, const Scene& scene);

nlohmann::ordered_json to_json(const PhotonStatistics& statistics);

}  // namespace tress
