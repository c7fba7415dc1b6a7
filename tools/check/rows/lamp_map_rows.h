// SPDX-License-Identifier: MIT
// Shadow maps of lamps in awkward places.
#pragma once

#include "tools/check/check_rows.h"

namespace tress {

std::vector<CheckRow> lamp_map_rows();  // D34

}  // namespace tress
