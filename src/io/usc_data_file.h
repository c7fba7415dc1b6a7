// SPDX-License-Identifier: MIT
// The .data format of USC-HairSalon (Hu et al. 2015): i32 strands; then, a strand, i32 points and f32 x, y, z each.
#pragma once

#include <string>

#include "io/strand_data.h"

namespace tress {

/// Throws InputError where the strands do not end where the file does, or there are none.
StrandData read_usc_data_file(const std::string& path);

}  // namespace tress
