// SPDX-License-Identifier: MIT
// Lines of a study as tables that spreadsheets read (RFC 4180).
#pragma once

#include <string>
#include <vector>

#include "tools/study/methods/row_result.h"

namespace tress {

/// One row a line, one column for each number or text in any of them, named by its JSON pointer ("layers/whole/bias").
std::string rows_csv(const std::vector<Json>& lines);

/// One row for each run, number of samples and layer: row, seed, spp, build and rendering seconds, layer, its errors.
std::string points_csv(const std::vector<MeasuredRow>& rows);

}  // namespace tress
