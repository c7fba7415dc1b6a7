// SPDX-License-Identifier: MIT
// tress plan: what would be built, what is left out, and why.
#pragma once

#include <CLI/CLI.hpp>

namespace tress {
void add_plan_command(CLI::App& app);
}  // namespace tress
