// SPDX-License-Identifier: MIT
// `tress trace`: the hair tree alone, on files of segments and rays.
#pragma once

namespace CLI {
class App;
}

namespace tress {

/// Adds the subcommand to `app`; its callback does the work, prints to stdout and throws InputError.
void add_trace_command(CLI::App& app);

}  // namespace tress
