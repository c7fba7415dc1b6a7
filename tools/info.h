// SPDX-License-Identifier: MIT
// `tress info FILE`: what a scene, hair, mesh or OpenEXR file holds.
#pragma once

#include <CLI/App.hpp>

namespace tress {

/// Adds the subcommand; its work is done in its callback, which throws InputError for a bad file.
void add_info_command(CLI::App& app);

}  // namespace tress
