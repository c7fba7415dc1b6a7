// SPDX-License-Identifier: MIT
// Short texts that stand for much: what is kept is found again by them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tress {

/// 16 digits.
std::string hexadecimal(uint64_t value);

/// 16 digits that stand for all of `parts`, in order.
std::string key_of(const std::vector<std::string>& parts);

}  // namespace tress
