// SPDX-License-Identifier: MIT
// How much of the gaps between cells must be added (CellTransmittance), found by rays; and what error is left. At hair
// and at polygons apart: a scalp sees hair that lies along it, and none of its own.
#pragma once

#include <span>

#include "gather/projection/light_trials.h"

namespace tress {

/// Compares light by projection with rays along the same directions. Where options say that rays choose the gap, sets
/// its share so that no bias is left; says what error is left in any case.
void calibrate_gap(PreparedScene& prepared, const Options& options, const LightTrials& trials);

}  // namespace tress
