// SPDX-License-Identifier: MIT
// tress study methods|convergence: error against run time, as JSON lines, CSV, plots and one page.
#pragma once

#include <CLI/CLI.hpp>

namespace tress {
void add_study_command(CLI::App& app);
}  // namespace tress
