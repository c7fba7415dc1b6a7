// SPDX-License-Identifier: MIT
// Settings of options, "key=value", as rows of a study have them, and grids of them.
#pragma once

#include <string>
#include <vector>

#include "core/options.h"

namespace tress {

/// Parts of a text between `at`.
std::vector<std::string> split(const std::string& text, char at);

/// `base` with these settings, in order. Throws InputError where a key or a value is none.
Options with_settings(Options base, const std::vector<std::string>& settings);

/// What a sweep sets, one list a point of the grid over "key=value,value,..." of each text; one empty list without
/// any. Throws InputError where a text is none, or the grid has more than 10,000 points.
std::vector<std::vector<std::string>> grid(const std::vector<std::string>& sweeps);

}  // namespace tress
