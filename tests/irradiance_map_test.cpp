// SPDX-License-Identifier: MIT
#include "gather/photons/irradiance_map.h"

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include <ctime>

#include "core/head.h"
#include "core/rng.h"
#include "core/sampling.h"
#include "tools/check/support/map_energy.h"

using namespace tress;
using namespace tress::test;

TEST_CASE("the map keeps the energy that lands, at edges, corners, creases and curves too") {
    const std::pair<const char*, TriangleMesh> meshes[] = {{"open box", open_box()},
                                                           {"sphere", sphere(64)},
                                                           {"coarse sphere", sphere(8)},
                                                           {"arch", arch(8, 0.4f)},
                                                           {"head", make_head()}};
    for (const auto& [name, mesh] : meshes) {
        const size_t n = 30'000;
        const PhotonList photons = uniform_photons(mesh, n, 1.0);
        const Energy e = energy(map_of(photons, mesh), mesh, 1.0, 100'000);
        CAPTURE(std::string(name));
        CAPTURE(e.share);
        CAPTURE(e.error);
        CHECK(std::abs(e.share - 1) < 0.01);
    }
}

TEST_CASE("beside hard shadows light is neither made nor lost, the less the more photons there are") {
    // The k nearest photons, asked for at photons alone, would make 31 % and 12 % of it here.
    const TriangleMesh mesh = unit_square();
    const std::pair<size_t, double> counts[] = {{10'000, 0.04}, {100'000, 0.01}};
    for (const auto& [n, bound] : counts) {
        const PhotonList all = uniform_photons(mesh, 2 * n, 2.0);
        PhotonList lit;
        for (size_t i = 0; i < all.size(); ++i) {
            const Vec3 p = all.position(i);
            if ((int(8 * p.x) + int(8 * p.y)) % 2 == 0)
                add(lit, {p, all.direction[i], all.power[i], PathType::type1}, all.normal[i]);
        }
        const Energy e = energy(map_of(lit, mesh), mesh, double(lit.size()) / double(n), 200'000);
        CAPTURE(n);
        CAPTURE(e.share);
        CHECK(std::abs(e.share - 1) < bound + 3 * e.error);
    }
}

TEST_CASE("irradiance is that of the light in the middle, at an edge and in a corner, and 0 on the other side") {
    const TriangleMesh mesh = open_box();
    constexpr size_t kPhotons = 100'000;
    const IrradianceMap map = map_of(uniform_photons(mesh, kPhotons, 5.0), mesh);  // 1 a unit of area
    // A place reads one estimate from about 50 photons under a cone: sd sqrt(3/2 / 50) = 0.17, twice that with a
    // quarter of the disc. Estimates over 0.02 of width, 10 radii of 0.014 squared, hold some 3 that are independent.
    for (const Vec2 middle : {Vec2(0.5f), Vec2(0.5f, 0.01f), Vec2(0.01f)}) {
        double sum = 0;
        constexpr int kReads = 400;
        for (uint64_t i = 0; i < kReads; ++i) {
            const float u = random(1, 2 * i) - 0.5f, v = random(1, 2 * i + 1) - 0.5f;
            const Vec3 at(middle + 0.02f * Vec2(u, v), 0);
            sum += double(irradiance(map, at, {0, 0, 1}).x);
            CHECK(irradiance(map, at, {0, 0, -1}) == Rgb(0));
        }
        CAPTURE(middle.x);
        CAPTURE(middle.y);
        CHECK(sum / kReads == doctest::Approx(1).epsilon(0.5));
    }
}

TEST_CASE("an unlit wall stays dark beside a lit one, and so does an unlit shelf under a lit one") {
    TriangleMesh mesh = unit_square();
    const PhotonList photons = uniform_photons(mesh, 20'000, 1.0);
    add_quad(mesh, {0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1});
    const float below = 0.1f;  // ten radii of the estimates' discs would be 0.3
    add_quad(mesh, {0, 0, -below}, {1, 0, -below}, {1, 1, -below}, {0, 1, -below});
    const IrradianceMap map = map_of(photons, mesh);
    for (uint64_t i = 0; i < 1000; ++i) {
        const float u = random(1, 2 * i), v = random(1, 2 * i + 1);
        CHECK(irradiance(map, {0, u, v}, {1, 0, 0}) == Rgb(0));
        CHECK(irradiance(map, {u, v, -below}, {0, 0, 1}) == Rgb(0));
    }
}

TEST_CASE("few photons, many at one point and radii of any size give finite light, and none gives none") {
    const TriangleMesh mesh = unit_square();
    PhotonList heap;
    for (int i = 0; i < 5000; ++i) add(heap, {Vec3(0.5f, 0.5f, 0), {0, 0, -1}, Rgb(1), PathType::type1}, {0, 0, 1});
    for (const PhotonList& photons :
         {PhotonList{}, uniform_photons(mesh, 1, 1), uniform_photons(mesh, 2, 1), uniform_photons(mesh, 30, 1), heap}) {
        for (const float radius : {0.0f, 1e-20f, 0.1f, 1e20f}) {
            PhotonOptions options;
            options.radius = radius;
            const IrradianceMap map = map_of(photons, mesh, options);
            CAPTURE(photons.size());
            CAPTURE(radius);
            for (const Rgb& light : map.irradiance) REQUIRE((is_finite(light) && min_component(light) >= 0));
            CHECK((photons.size() > 0 || irradiance(map, {0.5f, 0.5f, 0}, {0, 0, 1}) == Rgb(0)));
        }
    }
}

TEST_CASE("a heap of photons on a point takes no longer than as many spread out") {
    // 200,000 of them about each of 50,000 places would be 10^10 to add up: half a minute.
    const TriangleMesh mesh = unit_square();
    PhotonList heap;
    for (uint64_t i = 0; i < 200'000; ++i) {
        const float u = random(1, 2 * i), v = random(1, 2 * i + 1);
        add(heap, {Vec3(0.5f + 1e-6f * u, 0.5f + 1e-6f * v, 0), {0, 0, -1}, Rgb(1), PathType::type1}, {0, 0, 1});
    }
    const std::clock_t start = std::clock();
    const IrradianceMap map = map_of(heap, mesh);
    CHECK(double(std::clock() - start) / CLOCKS_PER_SEC < 10);
    for (const Rgb& light : map.irradiance) REQUIRE((is_finite(light) && min_component(light) >= 0));
}

TEST_CASE("fewer photons than an estimate takes still bring their energy") {
    const TriangleMesh mesh = unit_square();
    PhotonOptions options;
    options.nearest = 500;
    constexpr size_t kPhotons = 300;
    const Energy e = energy(map_of(uniform_photons(mesh, kPhotons, 1.0), mesh, options), mesh, 1.0, 10'000);
    CHECK(std::abs(e.share - 1) < 3 / std::sqrt(double(kPhotons)));
}

TEST_CASE("the irradiance map is the same for any number of threads") {
    const TriangleMesh mesh = open_box();
    const PhotonList photons = uniform_photons(mesh, 20'000, 1.0);
    const IrradianceMap map = map_of(photons, mesh);
    for (const size_t threads : {size_t(1), size_t(2), size_t(3)}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const IrradianceMap again = map_of(photons, mesh);
        CHECK(again.tree.id == map.tree.id);
        CHECK(again.irradiance == map.irradiance);
    }
}
