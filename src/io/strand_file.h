// SPDX-License-Identifier: MIT
// Hair from a file of any kind that is known: .hair by its first bytes, .data and .tfx by the ending of the name.
#pragma once

#include <string>

#include "io/strand_data.h"

namespace tress {

/// Whether the name of the file ends as a hair file's does.
bool is_strand_file_name(const std::string& path);

StrandData read_strand_file(const std::string& path);

}  // namespace tress
