// SPDX-License-Identifier: MIT
// This program run again in a process of its own: its memory is its own to count, and what ends it ends nothing else.
#pragma once

#include <string>
#include <vector>

namespace tress {

struct ChildResult {
    int exit_code = 0;  // 128 + signal where one ended it
    std::string error;  // the last line of what it said on stderr
};

/// Runs this program with `arguments` until it ends; it ends with this process, however that ends. Throws
/// std::runtime_error where no process can be had.
ChildResult run_self(const std::vector<std::string>& arguments);

}  // namespace tress
