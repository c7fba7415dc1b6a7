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

struct Igloo {
    static constexpr uint32_t kFewestCells = 4, kMostCells = 1 << 14;  // a hemisphere
    static constexpr int kSampleSide = 4;                              // rows and columns of a cell's samples
    static constexpr size_t kSamples = 16;                             // directions of a cell: kSampleSide squared
    static constexpr size_t kPadding = 16;                             // entries past the last, for whole vectors

    uint32_t cells = 0;               // a hemisphere
    std::vector<uint32_t> row_first;  // cells before each row, and one past the last
    std::vector<int32_t> row_of;  // one for each cell count k: the row of heights 1 - (k + 1) / cells to 1 - k / cells,
                                  // as first + count * 2^16
    std::vector<float> center_x, center_y, center_z;  // of each cell of the sphere, padded as `neighbor`
    float cell_radius = 0;                            // largest angle between a cell's middle and a direction in it
    std::vector<float> sample_x, sample_y, sample_z;  // kSamples of each cell of the upper hemisphere, in even rows of
                                                      // height and columns of azimuth
    std::vector<int32_t> neighbor;  // 4 x (2 cells): left, right, nearest above and below, over the sphere

    uint32_t rows() const { return uint32_t(row_first.size()) - 1; }
    uint32_t cells_of(Dome dome) const { return dome == Dome::sphere ? 2 * cells : cells; }
    float solid_angle() const { return 2 * kPi / float(cells); }
    /// Side of a square of a cell's solid angle, radians.
    float cell_size() const { return std::sqrt(solid_angle()); }
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
