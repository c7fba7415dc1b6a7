// SPDX-License-Identifier: MIT
// tress render: a scene to an EXR with layers, a PNG beside it, and figures of what it cost.
#pragma once

#include <CLI/CLI.hpp>

namespace tress {
void add_render_command(CLI::App& app);
}  // namespace tress
