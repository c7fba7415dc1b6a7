// SPDX-License-Identifier: MIT
// What readers of hair files return, and what they share. Points are taken as they are, finite or not: list_segments
// (core/segments.h) leaves out what cannot be traced.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/strands.h"
#include "io/byte_reader.h"

namespace tress {

struct StrandData {
    StrandSet strands;
    uint64_t dropped_strands = 0;  // of fewer than two points
};

/// Appends `count` points of `floats_each` numbers, of which the first three are x, y, z.
void append_points(ByteReader& in, uint64_t count, int floats_each, StrandSet& strands);

/// Appends `count` colours of `floats_each` numbers, of which the first three are red, green, blue.
void append_colors(ByteReader& in, uint64_t count, int floats_each, std::vector<Rgb>& colors);

/// Removes strands of fewer than two points, in all arrays and in `extra` (one a point, or empty); returns how many.
/// Throws InputError where none is left. `counts_at`: byte of the file that says how long strands are.
uint64_t drop_short_strands(const std::string& path, uint64_t counts_at, StrandSet& strands, std::vector<float>& extra);

/// Throws InputError where point indices would not fit into 32 bits.
void check_point_count(const std::string& path, uint64_t points);

}  // namespace tress
