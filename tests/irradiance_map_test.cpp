// SPDX-License-Identifier: MIT
#include "gather/irradiance_map.h"

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include "accel/build.h"
#include "core/head.h"
#include "core/rng.h"
#include "core/sampling.h"
#include "tests/surface_photons.h"

using namespace tress;
using namespace tress::test;

namespace {

/// Power that the map says lands, by uniformly spread places, in shares of `power`; with its standard error.
struct Energy {
    double share, error;
};
Energy energy(const IrradianceMap& map, const TriangleMesh& mesh, double power, size_t probes) {
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

IrradianceMap map_of(const PhotonList& photons, const TriangleMesh& mesh, const PhotonOptions& photon_options = {}) {
    Options options;
    options.photons = photon_options;
    return make_irradiance_map(photons, mesh, build_triangle_tree(mesh, options.accel), options);
}

}  // namespace

TEST_CASE("the map keeps the energy that lands, at edges, corners and curves too") {
    const std::pair<const char*, TriangleMesh> meshes[] = {
        {"open box", open_box()}, {"sphere", sphere(64)}, {"coarse sphere", sphere(8)}, {"arch", arch(8, 0.4f)}};
    for (const auto& [name, mesh] : meshes) {
        for (const size_t n : {size_t(10'000), size_t(100'000)}) {
            const PhotonList photons = uniform_photons(mesh, n, 1.0);
            const Energy e = energy(map_of(photons, mesh), mesh, 1.0, 200'000);
            CAPTURE(name);
            CAPTURE(n);
            CAPTURE(e.share);
            CAPTURE(e.error);
            MESSAGE(std::string(name) << " " << n << ": " << e.share << " +- " << e.error);
            CHECK(std::abs(e.share - 1) < 0.01);
        }
    }
}

TEST_CASE("X") {
    const TriangleMesh mesh = make_head();
    for (const size_t n : {size_t(3000), size_t(30'000), size_t(300'000)}) {
        const PhotonList photons = uniform_photons(mesh, n, 1.0);
        const Energy e = energy(map_of(photons, mesh), mesh, 1.0, 200'000);
        MESSAGE(n << ": " << e.share << " +- " << e.error);
    }
}
