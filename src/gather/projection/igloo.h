// SPDX-License-Identifier: MIT
// A hemisphere cut into cells of equal solid angle, row by row like the blocks of an igloo (Yuksel & Akleman 2006;
// Yuksel, Akleman & Keyser 2007, sec. 4.2). Row r ends at z = 1 - (cells so far) / cells, so that all cells are
// exactly equal, and the row of a direction is found by one look-up. At hair two hemispheres lie back to back: the cell
// below the cell c of the upper one, its mirror image, is c + cells.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/math.h"

namespace tress {

enum class Dome { hemisphere, sphere };  // at polygons, at hair

/// Samples of a cell: columns repeat after kSampleSide entries.
struct SampleRows {
    const float *cosine, *sine;            // Igloo::kColumnEntries
    const float *height, *radius, *slope;  // Igloo::kSamples
    float up;                              // -1: of the lower hemisphere, below by as much as these are above
};

struct Igloo {
    static constexpr uint32_t kFewestCells = 4, kMostCells = 1 << 14;  // a hemisphere
    static constexpr int kSampleSide = 8;                              // rows and columns of a cell's samples
    static constexpr size_t kSamples = 64;                             // directions of a cell: kSampleSide squared
    static constexpr size_t kColumnEntries = 16;                       // of columns: a whole vector of them, twice
    static constexpr size_t kPadding = 16;                             // entries past the last, for whole vectors

    uint32_t cells = 0;               // a hemisphere
    std::vector<uint32_t> row_first;  // cells before each row, and one past the last
    std::vector<int32_t> row_of;  // one for each cell count k: the row of heights 1 - (k + 1) / cells to 1 - k / cells,
                                  // as first + count * 2^16
    std::vector<float> center_x, center_y, center_z;  // of each cell of the sphere, padded as `neighbor`
    float cell_radius = 0;                            // largest angle between a cell's middle and a direction in it
    // Samples, in even rows of height and columns of azimuth, sample i in row i / kSampleSide and column i %
    // kSampleSide. Azimuths: kColumnEntries of each cell of the upper hemisphere. Heights: kSamples of each row of
    // cells.
    std::vector<float> column_cosine, column_sine;
    std::vector<float> sample_height, sample_radius, sample_slope;  // z, sqrt(1 - z^2), and one over the other
    std::vector<uint32_t> row_of_cell;                              // of each cell of the upper hemisphere
    std::vector<int32_t> neighbor;  // 4 x (2 cells): left, right, nearest above and below, over the sphere

    uint32_t rows() const { return uint32_t(row_first.size()) - 1; }
    uint32_t cells_of(Dome dome) const { return dome == Dome::sphere ? 2 * cells : cells; }
    float solid_angle() const { return 2 * kPi / float(cells); }
    /// Side of a square of a cell's solid angle, radians.
    float cell_size() const { return std::sqrt(solid_angle()); }
    SampleRows samples_of(uint32_t cell) const {
        const bool lower = cell >= cells;
        const uint32_t upper = lower ? cell - cells : cell;
        const size_t column = kColumnEntries * upper, row = kSamples * row_of_cell[upper];
        return {&column_cosine[column], &column_sine[column], &sample_height[row],
                &sample_radius[row],    &sample_slope[row],   lower ? -1.0f : 1.0f};
    }
};

/// `cells`: of a hemisphere, kFewestCells to kMostCells.
Igloo make_igloo(uint32_t cells);

/// Azimuth of (x, y) in turns, [0, 1], within 1e-6: a polynomial in each octant. Mirror images get mirrored turns.
float turn_of(float x, float y);

/// Cell of a unit direction given in the frame of the igloo; z >= 0 is the upper hemisphere.
uint32_t cell_of(const Igloo& igloo, const Vec3& direction);

/// Direction in a cell, uniform by solid angle for `u` uniform in [0, 1)^2.
Vec3 direction_in(const Igloo& igloo, uint32_t cell, const Vec2& u);

/// Integral of |cos| to the pole over a cell.
double cosine_integral(const Igloo& igloo, uint32_t cell);

}  // namespace tress
