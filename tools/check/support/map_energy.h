// SPDX-License-Identifier: MIT
// Irradiance maps of photons on a mesh, and the energy that they say lands there.
#pragma once

#include "accel/build.h"
#include "gather/photons/irradiance_map.h"
#include "tools/check/support/surface_photons.h"

namespace tress::test {

/// Power that the map says lands, by uniformly spread places, in shares of `power`; with its standard error.
struct Energy {
    double share, error;
};
inline Energy energy(const IrradianceMap& map, const TriangleMesh& mesh, double power, size_t probes) {
    const SurfaceSampler surface(mesh);
    double sum = 0, squares = 0;
    for (size_t i = 0; i < probes; ++i) {
        const SurfaceSample at = surface.sample(77, i);
        const double e = double(irradiance(map, at.position, at.normal).x);
        sum += e;
        squares += e * e;
    }
    const double n = double(probes), mean = sum / n, variance = (squares / n - mean * mean) / n;
    const double scale = surface.area() / power;
    return {mean * scale, std::sqrt(variance) * scale};
}

inline IrradianceMap map_of(const PhotonList& photons, const TriangleMesh& mesh,
                            const PhotonOptions& photon_options = {}) {
    Options options;
    options.photons = photon_options;
    return make_irradiance_map(photons, mesh, build_triangle_tree(mesh, options.accel), options);
}

}  // namespace tress::test
