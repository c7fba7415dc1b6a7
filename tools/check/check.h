// SPDX-License-Identifier: MIT
// tress check: every row of the table of stiff and extreme cases, measured here and now.
#pragma once

#include <CLI/CLI.hpp>

namespace tress {
void add_check_command(CLI::App& app);
}
