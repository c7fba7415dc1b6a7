// SPDX-License-Identifier: MIT
// Which light each photon comes from, and how it starts.
#pragma once

#include <vector>

#include "core/light_emission.h"
#include "core/path_type.h"
#include "core/rng.h"
#include "core/sampler.h"
#include "gather/prepared_scene.h"

namespace tress {

/// Lights share the photons by the luminance of their power.
struct PhotonSource {
    struct Share {
        uint32_t light;  // index in the scene
        double below;    // shares of those before it, of 1
        double factor;   // from an Emission's power to that of one photon; 0: no photons
    };
    Sphere sphere;  // about the scene
    std::vector<Share> shares;
    bool dark = true;  // no light emits
};

/// Lights that may have photons of use: those of the plan whose light can be of a type that is stored.
PhotonSource make_photon_source(const Scene& scene, const PreparedScene& prepared, const Plan& plan, int photons);

/// Key of the photons' sequence, photon i its sample i: no pixel has it.
constexpr uint64_t photon_key(uint64_t seed) {
    constexpr uint64_t kPhotons = 0x70686f746f6e7300;  // no picture has as many pixels
    return hash(seed, kPhotons);
}

struct StartingPhoton {
    uint32_t share;  // place in PhotonSource::shares
    LightSource source;
    Emission emission;  // power: of this photon; 0: it misses the scene
};
/// Uses the first group of the sampler's dimensions.
StartingPhoton start_photon(const PhotonSource& source, const Scene& scene, const PreparedScene& prepared,
                            const Sampler& sampler);

}  // namespace tress
