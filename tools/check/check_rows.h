// SPDX-License-Identifier: MIT
// All rows, by what they are about: one source each in rows/.
#pragma once

#include <vector>

#include "tools/check/check_row.h"

namespace tress {

std::vector<CheckRow> groom_rows();       // segments and strands as they are read: D1, D2, D4, D5, D7, D8
std::vector<CheckRow> hair_tree_rows();   // the tree of hair: D3, D6, D9, D10, D22 to D25, D36, D39
std::vector<CheckRow> projection_rows();  // projection onto cells: D11 to D18
std::vector<CheckRow> detail_rows();      // levels of detail: D19 to D21
std::vector<CheckRow> fiber_rows();       // scattering of a fiber: D26 to D31
std::vector<CheckRow> depth_rows();       // optical depth and maps of it: D32 to D35
std::vector<CheckRow> light_rows();       // photons and lamps: D37, D40
std::vector<CheckRow> picture_rows();     // whole pictures: D38, D41, D42, D45 to D47
std::vector<CheckRow> file_rows();        // files that are bad or cannot be written: D43, D44

/// In the order of their numbers.
std::vector<CheckRow> check_rows();

}  // namespace tress
