// SPDX-License-Identifier: MIT
// Photons from the lights through hair and off polygons (Jensen 1996): what the maps of photon_maps.h are made of.
// Hair is passed by roulette over {F: straight on, by a_k; R: scattered by f_R; absorbed}; polygons scatter diffusely.
#pragma once

#include "core/photon_statistics.h"
#include "gather/photons/photon_list.h"
#include "gather/prepared_scene.h"

namespace tress {

/// The most that both lists may take together. More is a mistake in photons.count.
inline constexpr size_t kMostPhotonBytes = size_t(4) << 30;

struct TracedPhotons {
    /// Every arrival where plan.polygon_gather; else those of the types in plan.photon_display.
    PhotonList on_polygons;
    /// At every fiber that a photon reaches, of the types in plan.photon_display: the sum over a ray's crossings of
    /// powers is unbiased, whether the photon goes straight on there, is scattered or absorbed.
    PhotonList in_hair;
    PhotonStatistics statistics;
};

/// options.photons.count photons from all lights together. Powers are for the whole: nothing is left to divide by the
/// count. Of `prepared` the trees, the attenuation and the environments are read. The same lists for any number of
/// threads and any instruction set. Lights whose photons could be of no type that is stored get none. Throws InputError
/// where the lists would take more than `most_bytes`.
TracedPhotons trace_photons(const Scene& scene, const PreparedScene& prepared, const Plan& plan, const Options& options,
                            size_t most_bytes = kMostPhotonBytes);

}  // namespace tress
