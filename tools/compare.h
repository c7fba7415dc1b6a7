// SPDX-License-Identifier: MIT
// tress compare REF.exr TEST.exr: how far a picture is from a reference.
#pragma once

#include <CLI/CLI.hpp>

namespace tress {

/// Adds the subcommand; it runs when it is parsed, and throws InputError.
void add_compare_command(CLI::App& app);

}  // namespace tress
