// SPDX-License-Identifier: MIT
// `tress groom NAME -o out.hair`: procedural hair as a file.
#pragma once

#include <CLI/App.hpp>

namespace tress {

/// Adds the subcommand; its work is done in its callback, which throws InputError for bad input.
void add_groom_command(CLI::App& app);

}  // namespace tress
