// SPDX-License-Identifier: MIT
#include "tools/check/check_rows.h"

#include <algorithm>
#include <cstdlib>

namespace tress {

std::vector<CheckRow> check_rows() {
    std::vector<CheckRow> rows;
    for (const auto& group : {groom_rows, hair_tree_rows, projection_rows, detail_rows, fiber_rows, depth_rows,
                              light_rows, picture_rows, file_rows}) {
        const std::vector<CheckRow> more = group();
        rows.insert(rows.end(), more.begin(), more.end());
    }
    const auto number = [](const CheckRow& row) { return std::atoi(row.id + 1); };  // of "D6"
    std::stable_sort(rows.begin(), rows.end(),
                     [&](const CheckRow& a, const CheckRow& b) { return number(a) < number(b); });
    return rows;
}

}  // namespace tress
