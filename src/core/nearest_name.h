// SPDX-License-Identifier: MIT
// For messages: the known name nearest to a mistyped one.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tress {

/// Of `known` (not empty), the one with the smallest edit distance to `name`; ties: the first.
std::string nearest_name(std::string_view name, std::span<const std::string> known);

/// "nearest known: 'spp'".
std::string did_you_mean(std::string_view name, std::span<const std::string> known);

}  // namespace tress
