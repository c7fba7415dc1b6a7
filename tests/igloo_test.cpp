// SPDX-License-Identifier: MIT
#include "gather/projection/igloo.h"

#include <doctest/doctest.h>

#include <numbers>
#include <numeric>

#include "core/rng.h"
#include "core/sampling.h"

using namespace tress;

namespace {

constexpr double kPiD = std::numbers::pi;
constexpr uint32_t kCells[] = {4, 16, 64, 100, 256, 1024, 4096, 16384};  // a hemisphere

struct Row {
    uint32_t row, first, count;
};

/// Of a cell of either hemisphere.
Row row_of(const Igloo& igloo, uint32_t cell) {
    cell %= igloo.cells;
    uint32_t row = 0;
    while (igloo.row_first[row + 1] <= cell) ++row;
    return {row, igloo.row_first[row], igloo.row_first[row + 1] - igloo.row_first[row]};
}

/// A place in a cell that rounding keeps off its edges. A height is known to 2^-24, in cells of a row of `count`
/// 2^-24 cells / count; an azimuth to 1e-6 turns, 1e-6 count cells. Twice that, and 1e-4.
Vec2 inner_place(const Igloo& igloo, const Row& row, uint64_t key) {
    const double x = 1e-4 + 0x1p-23 * igloo.cells / row.count, y = 1e-4 + 2e-6 * row.count;
    return {float(glm::mix(x, 1 - x, double(random(key, 0)))), float(glm::mix(y, 1 - y, double(random(key, 1))))};
}

Vec3 inner_direction(const Igloo& igloo, uint32_t cell, uint64_t key) {
    return direction_in(igloo, cell, inner_place(igloo, row_of(igloo, cell), key));
}

double angle(const Vec3& a, const Vec3& b) {
    return std::atan2(length(cross(DVec3(a), DVec3(b))), dot(DVec3(a), DVec3(b)));
}

uint32_t neighbor(const Igloo& igloo, int side, uint32_t cell) {
    return uint32_t(igloo.neighbor[size_t(side) * 2 * igloo.cells + cell]);
}

uint32_t mirrored(const Igloo& igloo, uint32_t cell) {
    return cell < igloo.cells ? cell + igloo.cells : cell - igloo.cells;
}

}  // namespace

TEST_CASE("rows hold all cells, and every height is in the row that its look-up says") {
    for (const uint32_t cells : kCells) {
        CAPTURE(cells);
        const Igloo igloo = make_igloo(cells);
        CHECK(igloo.cells == cells);
        CHECK(igloo.cells_of(Dome::hemisphere) == cells);
        CHECK(igloo.cells_of(Dome::sphere) == 2 * cells);
        REQUIRE(igloo.rows() >= 2);
        CHECK(igloo.row_first.front() == 0);
        CHECK(igloo.row_first.back() == cells);
        for (uint32_t r = 0; r < igloo.rows(); ++r) CHECK(igloo.row_first[r] < igloo.row_first[r + 1]);
        REQUIRE(igloo.row_of.size() >= cells);
        for (uint32_t k = 0; k < cells; ++k) {
            const Row row = row_of(igloo, k);
            REQUIRE(uint32_t(igloo.row_of[k]) == (row.first | row.count << 16));
        }
    }
}

// Sums in double of `cells` terms lose at most cells 2^-53; the solid angle itself is rounded to float.
TEST_CASE("solid angles sum to 2 pi, and integrals of the cosine to pi") {
    for (const uint32_t cells : kCells) {
        CAPTURE(cells);
        const Igloo igloo = make_igloo(cells);
        double solid = 0, cosine = 0;
        for (uint32_t cell = 0; cell < cells; ++cell) {
            const Row row = row_of(igloo, cell);
            solid += 2 * kPiD * (double(igloo.row_first[row.row + 1]) - row.first) / cells / row.count;
            cosine += cosine_integral(igloo, cell);
            REQUIRE(cosine_integral(igloo, cell) == cosine_integral(igloo, mirrored(igloo, cell)));
        }
        CHECK(std::abs(solid / (2 * kPiD) - 1) < 1e-12);
        CHECK(std::abs(cosine / kPiD - 1) < 1e-12);
        CHECK(std::abs(double(igloo.solid_angle()) * cells / (2 * kPiD) - 1) < 0x1p-22);
    }
}

// Height is linear in u.x: its mean over a cell is that of the cell's middle, to a few roundings of 2^-24 of 1.
TEST_CASE("the integral of the cosine is the solid angle times the mean height of the cell's directions") {
    for (const uint32_t cells : kCells) {
        CAPTURE(cells);
        const Igloo igloo = make_igloo(cells);
        double worst = 0;
        for (uint32_t cell = 0; cell < cells; ++cell) {
            const double mean = double(direction_in(igloo, cell, {0.5f, 0.5f}).z);
            worst = std::max(worst, std::abs(cosine_integral(igloo, cell) * cells / (2 * kPiD) - mean));
        }
        CHECK(worst < 4 * 0x1p-24);
    }
}

TEST_CASE("directions in a cell are of unit length and are found in it again") {
    for (const uint32_t cells : kCells) {
        CAPTURE(cells);
        const Igloo igloo = make_igloo(cells);
        uint32_t lost = 0;
        double off_unit = 0;
        for (uint32_t cell = 0; cell < 2 * cells; ++cell)
            for (uint64_t i = 0; i < 8; ++i) {
                const Vec3 direction = inner_direction(igloo, cell, hash(cell, i));
                lost += cell_of(igloo, direction) != cell;
                off_unit = std::max(off_unit, std::abs(length(DVec3(direction)) - 1));
            }
        CHECK(lost == 0);
        CHECK(off_unit < 4 * 0x1p-24);
    }
}

TEST_CASE("a cell's samples are in it, and no direction in it is farther from its middle than cells reach") {
    for (const uint32_t cells : {4u, 64u, 1000u}) {
        const Igloo igloo = make_igloo(cells);
        for (uint32_t cell = 0; cell < 2 * cells; ++cell) {
            const Vec3 middle(igloo.center_x[cell], igloo.center_y[cell], igloo.center_z[cell]);
            const SampleRows samples = igloo.samples_of(cell);
            for (size_t i = 0; i < Igloo::kSamples; ++i) {
                const size_t column = i % Igloo::kColumnEntries;
                const Vec3 sample(samples.radius[i] * samples.cosine[column], samples.radius[i] * samples.sine[column],
                                  samples.up * samples.height[i]);
                REQUIRE(cell_of(igloo, sample) == cell);
                REQUIRE(samples.slope[i] == samples.height[i] / samples.radius[i]);
                CHECK(length(sample) == doctest::Approx(1).epsilon(1e-6));
            }
            for (uint64_t i = 0; i < 20; ++i) {
                const Vec3 w = direction_in(igloo, cell, {tress::random(i, 0), tress::random(i, 1)});
                CHECK(dot(w, middle) >= std::cos(igloo.cell_radius) - 1e-5f);
            }
        }
    }
}

// Chi-square of k degrees of freedom has the mean k and the variance 2 k: 5 standard deviations.
TEST_CASE("directions drawn uniformly fall into all cells alike") {
    for (const uint32_t cells : kCells) {
        CAPTURE(cells);
        const Igloo igloo = make_igloo(cells);
        const size_t bins = igloo.cells_of(Dome::sphere), drawn = std::max<size_t>(100'000, 32 * bins);
        std::vector<uint32_t> count(bins);
        for (uint64_t i = 0; i < drawn; ++i) {
            const uint64_t key = hash(11, i);
            ++count.at(cell_of(igloo, sample_uniform_sphere({random(key, 0), random(key, 1)})));
        }
        const double expected = double(drawn) / double(bins), freedom = double(bins - 1);
        double chi_square = 0;
        for (const uint32_t c : count) chi_square += square(double(c) - expected) / expected;
        CAPTURE(chi_square);
        CHECK(std::abs(chi_square - freedom) < 5 * std::sqrt(2 * freedom));
    }
}

TEST_CASE("mirror images of directions fall into mirror images of cells") {
    for (const uint32_t cells : kCells) {
        CAPTURE(cells);
        const Igloo igloo = make_igloo(cells);
        uint32_t wrong_y = 0, wrong_z = 0;
        for (uint32_t cell = 0; cell < 2 * cells; ++cell) {
            const Row row = row_of(igloo, cell);
            const uint32_t below = cell - cell % cells, column = cell % cells - row.first;
            const Vec3 d = inner_direction(igloo, cell, hash(12, cell));
            wrong_y += cell_of(igloo, {d.x, -d.y, d.z}) != below + row.first + row.count - 1 - column;
            wrong_z += cell_of(igloo, {d.x, d.y, -d.z}) != mirrored(igloo, cell);
        }
        CHECK(wrong_y == 0);
        CHECK(wrong_z == 0);
    }
}

TEST_CASE("extreme directions have a cell") {
    for (const uint32_t cells : kCells) {
        const Igloo igloo = make_igloo(cells);
        for (const float z : {-1.0f, -0.0f, 0.0f, 1.0f, 1.0000001f, -1.0000001f, 1e-30f, -1e-30f})
            for (const float x : {-1.0f, -1e-30f, -0.0f, 0.0f, 1e-30f, 1.0f})
                for (const float y : {-1.0f, -1e-30f, -0.0f, 0.0f, 1e-30f, 1.0f}) {
                    CAPTURE(Vec3(x, y, z).x);
                    CAPTURE(y);
                    CAPTURE(z);
                    const uint32_t cell = cell_of(igloo, {x, y, z});
                    CHECK(cell < 2 * cells);
                    CHECK((cell >= cells) == (z < 0));
                }
    }
}

TEST_CASE("neighbours are near, and those of the lower hemisphere mirror those of the upper") {
    for (const uint32_t cells : kCells) {
        CAPTURE(cells);
        const Igloo igloo = make_igloo(cells);
        REQUIRE(igloo.neighbor.size() >= 8 * size_t(cells));
        double farthest = 0;
        uint32_t not_mirrored = 0;
        const auto center = [&](uint32_t cell) { return direction_in(igloo, cell, {0.5f, 0.5f}); };
        for (uint32_t cell = 0; cell < 2 * cells; ++cell)
            for (int side = 0; side < 4; ++side) {
                const uint32_t beside = neighbor(igloo, side, cell);
                REQUIRE(beside < 2 * cells);
                farthest = std::max(farthest, angle(center(cell), center(beside)));
                not_mirrored += neighbor(igloo, side, mirrored(igloo, cell)) != mirrored(igloo, beside);
            }
        CHECK(farthest < 3 * double(igloo.cell_size()));
        CHECK(not_mirrored == 0);
    }
}

TEST_CASE("neighbours lie left and right in the row, above and below in the next, across the horizon mirrored") {
    for (const uint32_t cells : kCells) {
        CAPTURE(cells);
        const Igloo igloo = make_igloo(cells);
        uint32_t wrong = 0;
        for (uint32_t cell = 0; cell < cells; ++cell) {
            const uint32_t row = row_of(igloo, cell).row, left = neighbor(igloo, 0, cell);
            const uint32_t above = neighbor(igloo, 2, cell), below = neighbor(igloo, 3, cell);
            wrong += row_of(igloo, left).row != row || neighbor(igloo, 1, left) != cell;
            wrong += above >= cells || row_of(igloo, above).row != (row == 0 ? 0 : row - 1);
            wrong +=
                row + 1 == igloo.rows() ? below != cell + cells : below >= cells || row_of(igloo, below).row != row + 1;
        }
        CHECK(wrong == 0);
    }
}

// The polynomial is good to 3e-7, a few roundings of numbers up to 1 beside it.
TEST_CASE("azimuths are within a millionth of a turn, and mirrored exactly") {
    double worst = 0;
    for (uint64_t i = 0; i < 200'000; ++i) {
        const uint64_t key = hash(13, i);
        const float scale = std::exp2(60 * random(key, 2) - 30);
        const float x = scale * (2 * random(key, 0) - 1), y = scale * (2 * random(key, 1) - 1);
        const double turn = std::atan2(double(y), double(x)) / (2 * kPiD), expected = turn < 0 ? turn + 1 : turn;
        worst = std::max(worst, std::abs(double(turn_of(x, y)) - expected));
        if (y != 0) REQUIRE(turn_of(x, -std::abs(y)) == 1 - turn_of(x, std::abs(y)));
    }
    CHECK(worst < 1e-6);
    CHECK(turn_of(0, 0) == 0);
    CHECK(turn_of(1, 0) == 0);
    CHECK(turn_of(0, 1) == 0.25f);
    CHECK(turn_of(-1, 0) == 0.5f);
    CHECK(turn_of(0, -1) == 0.75f);
    CHECK(std::abs(turn_of(1, 1) - 0.125f) < 1e-6f);
}
