// SPDX-License-Identifier: MIT
#include "gather/projection/near_cells.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/rng.h"

using namespace tress;

namespace {

constexpr Rgbx kOpacity = {{1.0f, 0.6f, 0.1f, 0}};

/// Each sample is covered by chance.
uint64_t random_samples(uint64_t key, float chance) {
    uint64_t samples = 0;
    for (uint64_t i = 0; i < 64; ++i)
        if (random(key, uint32_t(i)) < chance) samples |= uint64_t(1) << i;
    return samples;
}

}  // namespace

TEST_CASE("several pieces let through the mean over samples of what covers each") {
    for (const int pieces : {2, 3, 7, 15}) {
        CAPTURE(pieces);
        NearCell cell;
        double count[64] = {};
        for (int piece = 0; piece < pieces; ++piece) {
            const uint64_t samples = random_samples(hash(1, uint64_t(piece)), 0.7f);
            cell.add(uint32_t(piece), 0, samples, kOpacity);
            for (int i = 0; i < 64; ++i) count[i] += double(samples >> i & 1);
        }
        const Rgbx through = cell.transmittance();
        for (int c = 0; c < 3; ++c) {
            double expected = 0;
            for (const double n : count) expected += std::pow(1 - double(kOpacity.c[c]), n) / 64;
            CHECK(double(through.c[c]) == doctest::Approx(expected).epsilon(1e-5));
        }
    }
}

TEST_CASE("more than fifteen pieces one behind another count as fifteen") {
    NearCell fifteen, many;
    for (uint32_t piece = 0; piece < 40; ++piece) {
        if (piece < 15) fifteen.add(piece, 1, ~uint64_t(0), kOpacity);
        many.add(piece, 1, ~uint64_t(0), kOpacity);
    }
    for (int c = 0; c < 3; ++c) CHECK(many.transmittance().c[c] == doctest::Approx(fifteen.transmittance().c[c]));
}

TEST_CASE("what one segment lets through is known by its solid angle, whatever its samples are") {
    NearCell cell;
    for (int piece = 0; piece < 3; ++piece)
        cell.add(5, 0.125f, random_samples(hash(2, uint64_t(piece)), 0.3f), kOpacity);
    for (int c = 0; c < 3; ++c) CHECK(cell.transmittance().c[c] == 1 - 3 * (0.125f * kOpacity.c[c]));
}

TEST_CASE("a cell without near hair lets all through, and one that is all covered nothing") {
    NearCell cell;
    for (int c = 0; c < 3; ++c) CHECK(cell.transmittance().c[c] == 1);
    const Rgbx opaque = {{1, 1, 1, 0}};
    cell.add(1, 1.5f, ~uint64_t(0), opaque);
    for (int c = 0; c < 3; ++c) CHECK(cell.transmittance().c[c] == 0);
    cell.add(2, 1, ~uint64_t(0), opaque);
    for (int c = 0; c < 3; ++c) CHECK(cell.transmittance().c[c] == 0);
}

TEST_CASE("hair behind polygons hides what is beyond, and nothing that is in sight") {
    NearCells near;
    near.clear(4);
    near.cells[1].add(0, 0.25f, 0, kOpacity);
    near.cells[3].add(1, 0.5f, 0, kOpacity);  // the same cell's, behind
    CHECK(near.through(1, 2, true).c[0] == 0.75f);
    CHECK(near.through(1, 2, false).c[0] == 0.375f);
    CHECK(near.through(0, 2, false).c[0] == 1);
}
