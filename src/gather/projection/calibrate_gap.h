// SPDX-License-Identifier: MIT
// How much of the gaps between cells must be added (CellTransmittance), found by rays; and what error is left.
#pragma once

#include <span>

#include "gather/projection/light_trials.h"

namespace tress {

/// Compares light by projection with rays along the same directions. Where options say that rays choose the gap, sets
/// it so that no bias is left; sets prepared.projection.error in any case.
void calibrate_gap(PreparedScene& prepared, const Options& options, std::span<const LightTrial> trials);

}  // namespace tress
