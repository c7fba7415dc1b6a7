// SPDX-License-Identifier: MIT
// The .tfx format of TressFX, versions 3 and 4: strands of one and the same number of points. Thickness is a width
// across, one a strand; colours are one a point; only version 4 says where they are, and few files have them.
#pragma once

#include <string>

#include "io/strand_data.h"

namespace tress {

/// Guides only: the format leaves the strands about them to whoever reads it (grow_children in core/groom.h).
StrandData read_tfx_file(const std::string& path);

}  // namespace tress
