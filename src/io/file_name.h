// SPDX-License-Identifier: MIT
// Names of files as users and scene files write them.
#pragma once

#include <string>

namespace tress {

/// ".obj" of "Head.OBJ"; empty where there is none.
std::string file_ending(const std::string& path);

/// `text` with every ${NAME} replaced from the environment, and, where the result is relative, within `folder`.
/// Throws InputError that names `where` for a name that is not set or a brace that is not closed.
std::string resolved_file_name(const std::string& where, const std::string& text, const std::string& folder);

}  // namespace tress
