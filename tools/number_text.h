// SPDX-License-Identifier: MIT
// Numbers as a reader of a page wants them.
#pragma once

#include <string>

namespace tress {

/// So many significant digits, whole numbers in full: "12.3", "0.00123", "1.23e-5", "12345".
std::string significant(double value, int digits = 3);
/// "1.2 s", "3 min 20 s", "2 h 5 min".
std::string duration(double seconds);
/// "1,234,567".
std::string grouped(unsigned long long value);

}  // namespace tress
