// SPDX-License-Identifier: MIT
#include "tools/check/rows/projection_rows.h"

#include "tools/check/check_rows.h"

namespace tress {

std::vector<CheckRow> projection_rows() {
    std::vector<CheckRow> rows;
    for (const auto& some : {hair_at_point_rows(), cell_border_rows(), coverage_rows(), igloo_rows()})
        rows.insert(rows.end(), some.begin(), some.end());
    return rows;
}

}  // namespace tress
