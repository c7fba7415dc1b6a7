// SPDX-License-Identifier: MIT
#include "gather/projection/igloo.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/sampling.h"
#include "gather/projection/polynomials.h"

namespace tress {
namespace {

constexpr double kHalfPi = std::numbers::pi / 2;

/// Cells before each row: rows of even height in angle, their counts rounded so that all cells are equal.
std::vector<uint32_t> row_starts(uint32_t cells) {
    const double side = std::sqrt(2 * std::numbers::pi / cells);
    const uint32_t rows = std::max(uint32_t(std::lround(kHalfPi / side)), 2u);
    std::vector<uint32_t> first = {0};
    for (uint32_t r = 1; r <= rows; ++r) {
        const double above = 1 - std::cos(kHalfPi * r / rows);
        first.push_back(std::max(uint32_t(std::lround(cells * above)), first.back() + 1));
    }
    first.back() = cells;
    return first;
}

struct Place {
    uint32_t row, column, count;
};

Place place_of(const Igloo& igloo, uint32_t cell) {
    const auto next = std::upper_bound(igloo.row_first.begin(), igloo.row_first.end(), cell);
    const uint32_t row = uint32_t(next - igloo.row_first.begin()) - 1;
    return {row, cell - igloo.row_first[row], igloo.row_first[row + 1] - igloo.row_first[row]};
}

/// Cell of `row` at the azimuth of the middle of `at`.
uint32_t beside(const Igloo& igloo, const Place& at, uint32_t row) {
    const uint32_t first = igloo.row_first[row], count = igloo.row_first[row + 1] - first;
    return first + uint32_t((2 * at.column + 1) * uint64_t(count) / (2 * at.count));
}

/// Of a cell of the upper hemisphere.
std::array<uint32_t, 4> neighbors(const Igloo& igloo, uint32_t cell) {
    const Place at = place_of(igloo, cell);
    const uint32_t first = cell - at.column;
    const uint32_t across = first + (at.column + at.count / 2) % at.count;  // over the pole
    return {first + (at.column + 1) % at.count, first + (at.column + at.count - 1) % at.count,
            at.row == 0 ? across : beside(igloo, at, at.row - 1),
            at.row + 1 == igloo.rows() ? cell + igloo.cells : beside(igloo, at, at.row + 1)};
}

void find_neighbors(Igloo& igloo) {
    const uint32_t all = 2 * igloo.cells;
    const auto mirrored = [&](uint32_t cell) { return cell < igloo.cells ? cell + igloo.cells : cell - igloo.cells; };
    igloo.neighbor.resize(4 * size_t(all) + Igloo::kPadding);
    for (uint32_t cell = 0; cell < igloo.cells; ++cell) {
        const std::array<uint32_t, 4> beside = neighbors(igloo, cell);
        for (size_t side = 0; side < 4; ++side) {
            igloo.neighbor[side * all + cell] = int32_t(beside[side]);
            igloo.neighbor[side * all + mirrored(cell)] = int32_t(mirrored(beside[side]));
        }
    }
}

/// A direction of a cell of the upper hemisphere, such that those of a row are mirror images at the plane y = 0 to the
/// bit: a mirrored scene gives mirrored cells. `u`: of a cell that the plane does not cut; `halved`: of one that it
/// cuts in two, whose halves are mirror images.
Vec3 mirrored_direction(const Igloo& igloo, uint32_t cell, const Vec2& u, const Vec2& halved, bool second_half) {
    const Place at = place_of(igloo, cell);
    const uint32_t mirrored = at.count - 1 - at.column;
    const Vec3 w = at.column < mirrored   ? direction_in(igloo, cell, u)
                   : at.column > mirrored ? direction_in(igloo, cell - at.column + mirrored, u)
                                          : direction_in(igloo, cell, halved);
    const bool flip = at.column > mirrored || (at.column == mirrored && second_half);
    return {w.x, flip ? -w.y : w.y, w.z};
}

void find_centers(Igloo& igloo) {
    for (auto* row : {&igloo.center_x, &igloo.center_y, &igloo.center_z})
        row->assign(2 * size_t(igloo.cells) + Igloo::kPadding, 0);
    for (uint32_t cell = 0; cell < igloo.cells; ++cell) {
        const Place at = place_of(igloo, cell);
        Vec3 center = mirrored_direction(igloo, cell, Vec2(0.5f), Vec2(0.5f), false);
        if (2 * at.column + 1 == at.count) center.y = 0;  // but for rounding
        for (const float up : {1.0f, -1.0f}) {
            const size_t i = up > 0 ? cell : cell + igloo.cells;
            igloo.center_x[i] = center.x, igloo.center_y[i] = center.y, igloo.center_z[i] = up * center.z;
        }
    }
}

void find_samples(Igloo& igloo) {
    constexpr int kSide = Igloo::kSampleSide;
    static_assert(Igloo::kSamples == kSide * kSide && kSide % 2 == 0 && Igloo::kColumnEntries % kSide == 0);
    const auto middle_of = [](int part) { return (float(part) + 0.5f) / kSide; };
    for (uint32_t cell = 0; cell < igloo.cells; ++cell) {
        igloo.row_of_cell.push_back(place_of(igloo, cell).row);
        for (int i = 0; i < int(Igloo::kColumnEntries); ++i) {
            const int column = i % kSide;
            const Vec2 place(0.5f, middle_of(column)), halved(0.5f, middle_of(std::min(column, kSide - 1 - column)));
            const Vec3 w = mirrored_direction(igloo, cell, place, halved, 2 * column >= kSide);
            const float radius = std::sqrt(w.x * w.x + w.y * w.y);
            igloo.column_cosine.push_back(w.x / radius), igloo.column_sine.push_back(w.y / radius);
        }
    }
    for (uint32_t row = 0; row < igloo.rows(); ++row)
        for (int i = 0; i < int(Igloo::kSamples); ++i) {
            const Vec3 w = direction_in(igloo, igloo.row_first[row], {middle_of(i / kSide), 0.5f});
            const float radius = std::sqrt(w.x * w.x + w.y * w.y);
            igloo.sample_height.push_back(w.z), igloo.sample_radius.push_back(radius);
            igloo.sample_slope.push_back(w.z / radius);
        }
}

void find_cell_radius(Igloo& igloo) {
    float least_cosine = 1;
    for (uint32_t cell = 0; cell < igloo.cells; ++cell)
        for (const Vec2& corner : {Vec2(0, 0), Vec2(0, 1), Vec2(1, 0), Vec2(1, 1)})
            least_cosine =
                std::min(least_cosine, dot(Vec3(igloo.center_x[cell], igloo.center_y[cell], igloo.center_z[cell]),
                                           direction_in(igloo, cell, corner)));
    igloo.cell_radius = std::acos(std::clamp(least_cosine, -1.0f, 1.0f));
}

}  // namespace

Igloo make_igloo(uint32_t cells) {
    assert(cells >= Igloo::kFewestCells && cells <= Igloo::kMostCells);
    Igloo igloo;
    igloo.cells = cells;
    igloo.row_first = row_starts(cells);
    for (uint32_t row = 0; row < igloo.rows(); ++row) {
        const uint32_t first = igloo.row_first[row], count = igloo.row_first[row + 1] - first;
        igloo.row_of.insert(igloo.row_of.end(), count, int32_t(first | count << 16));
    }
    find_neighbors(igloo);
    find_centers(igloo);
    find_samples(igloo);
    find_cell_radius(igloo);
    return igloo;
}

float turn_of(float x, float y) {
    const float ax = std::abs(x), ay = std::abs(y);
    const float high = std::max(ax, ay), low = std::min(ax, ay);
    const float t = low / std::max(high, std::numeric_limits<float>::min());
    const float s = t * t;
    float octant = 0;
    for (size_t i = std::size(kTurnPolynomial); i-- > 0;) octant = octant * s + kTurnPolynomial[i];
    octant *= t;
    const float quarter = ay > ax ? 0.25f - octant : octant;
    const float half = x < 0 ? 0.5f - quarter : quarter;
    return y < 0 ? 1 - half : half;
}

uint32_t cell_of(const Igloo& igloo, const Vec3& direction) {
    const float cells = float(igloo.cells), below = std::nearbyint((cells - 0.5f) - cells * std::abs(direction.z));
    const uint32_t k = std::min(uint32_t(std::max(below, 0.0f)), igloo.cells - 1);
    const uint32_t first = uint32_t(igloo.row_of[k]) & 0xffff, count = uint32_t(igloo.row_of[k]) >> 16;
    const float column = std::nearbyint(turn_of(direction.x, direction.y) * float(count) - 0.5f);
    return first + std::min(uint32_t(column), count - 1) + (direction.z < 0 ? igloo.cells : 0);
}

Vec3 direction_in(const Igloo& igloo, uint32_t cell, const Vec2& u) {
    const bool lower = cell >= igloo.cells;
    const Place at = place_of(igloo, lower ? cell - igloo.cells : cell);
    const float below = (float(igloo.row_first[at.row]) + u.x * float(at.count)) / float(igloo.cells);
    Vec3 direction = direction_below_pole(below, (float(at.column) + u.y) / float(at.count));
    if (lower) direction.z = -direction.z;
    return direction;
}

double cosine_integral(const Igloo& igloo, uint32_t cell) {
    const Place at = place_of(igloo, cell < igloo.cells ? cell : cell - igloo.cells);
    const double n = igloo.cells;
    const double top = 1 - igloo.row_first[at.row] / n, bottom = 1 - igloo.row_first[at.row + 1] / n;
    return std::numbers::pi * (top * top - bottom * bottom) / at.count;
}

}  // namespace tress
