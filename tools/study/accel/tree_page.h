// SPDX-License-Identifier: MIT
// The page of a study of trees: tables and plots of its results.
#pragma once

#include "tools/study/page.h"

namespace tress {

/// `rows`: tree_result.h. `spread`: tree_spread.h.
Page make_tree_page(const Json& header, const std::vector<Json>& rows, const Json& spread);

}  // namespace tress
