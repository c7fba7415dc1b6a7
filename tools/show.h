// SPDX-License-Identifier: MIT
// tress show PICTURE.exr -o OUT.png: layers of a picture, one by one or summed, side by side.
#pragma once

#include <CLI/CLI.hpp>

namespace tress {

/// Adds the subcommand; it runs when it is parsed, and throws InputError.
void add_show_command(CLI::App& app);

}  // namespace tress
