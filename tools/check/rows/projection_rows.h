// SPDX-License-Identifier: MIT
// The rows of projection, by what they are about.
#pragma once

#include <vector>

#include "tools/check/check_row.h"

namespace tress {

std::vector<CheckRow> hair_at_point_rows();  // hair that a point is on or in: D11, D12
std::vector<CheckRow> cell_border_rows();    // hair over the pole and the seam of azimuths: D13, D14
std::vector<CheckRow> coverage_rows();       // how much of the cells is covered: D15, D16
std::vector<CheckRow> igloo_rows();          // the cells themselves: D17, D18

}  // namespace tress
