// SPDX-License-Identifier: MIT
// A row of a study of trees: the options of `accel` that it sets over the scene's.
#pragma once

#include <string>
#include <vector>

#include "core/options.h"

namespace tress {

struct TreeRow {
    std::string name;                   // "traversal_cost=5, clip=false"
    std::vector<std::string> settings;  // "accel.traversal_cost=5", ...
};

/// The scene's own options; each of `rows` ("accel.key=value ...") at each point of the grid of `sweeps`
/// ("accel.key=value,value,..."). Where neither says anything, a list that goes through each option; `few`: a short
/// one. Throws InputError, also where a setting is not of accel.
std::vector<TreeRow> tree_rows(const std::vector<std::string>& rows, const std::vector<std::string>& sweeps, bool few);

}  // namespace tress
