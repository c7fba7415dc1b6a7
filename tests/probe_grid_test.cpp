// SPDX-License-Identifier: MIT
#include "gather/projection/probe_grid.h"

#include <doctest/doctest.h>

#include <map>

#include "core/rng.h"

using namespace tress;

namespace {

const Bounds kHair{Vec3(-3, 1, 100), Vec3(5, 4, 102)};

Vec3 place_in(const Bounds& box, uint64_t i) {
    return box.lo + box.extent() * Vec3(tress::random(i, 0), tress::random(i, 1), tress::random(i, 2));
}

}  // namespace

TEST_CASE("corners interpolate their own positions to the place") {
    const ProbeGrid grid = make_probe_grid(hair_cube(kHair), 16);
    CHECK(grid.size == 8 * 1.02f / 16);
    for (uint64_t i = 0; i < 1000; ++i) {
        const Vec3 place = place_in(kHair, i);
        const ProbeCube cube = cube_at(grid, place);
        Vec3 mean(0);
        float sum = 0;
        for (int corner = 0; corner < 8; ++corner) {
            CHECK(cube.weight(corner) >= 0);
            sum += cube.weight(corner);
            mean += cube.weight(corner) * cube.corner(corner);
        }
        // Roundings of coordinates of about 100.
        CHECK(sum == doctest::Approx(1).epsilon(1e-5));
        CHECK(length(mean - place) < 1e-4f);
    }
}

TEST_CASE("cubes that share a corner know it by one key, and other corners by others") {
    const ProbeGrid grid = make_probe_grid(hair_cube(kHair), 16);
    std::map<uint64_t, Vec3> corners;
    for (uint64_t i = 0; i < 1000; ++i) {
        const ProbeCube cube = cube_at(grid, place_in(kHair, i));
        for (int corner = 0; corner < 8; ++corner) {
            const auto [known, added] = corners.emplace(cube.key(corner), cube.corner(corner));
            CHECK(known->second == cube.corner(corner));
        }
    }
    CHECK(corners.size() > 500);
}

TEST_CASE("hair without extent has a grid") {
    const Vec3 point(1, 2, 3);
    const ProbeCube cube = cube_at(make_probe_grid(hair_cube({point, point}), 16), point);
    CHECK(cube.grid.size == 1);
    CHECK(cube.weight(0) > 0);
}
