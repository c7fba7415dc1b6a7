// SPDX-License-Identifier: MIT
// Which shares of the gaps between cells and of their scatter (GapShares) rays ask for; and what error is left. At hair
// and at polygons apart: a scalp sees hair that lies along it, and none of its own.
#pragma once

#include <span>

#include "gather/projection/light_trials.h"

namespace tress {

/// Compares light by projection with rays along the same directions. Where options say that rays choose the gap, sets
/// the shares of least squares that leave no bias (fit_gaps); at polygons those of hair, where there is no light to
/// tell by. Says what error is left, of the same light, in any case.
void calibrate_gap(PreparedScene& prepared, const Options& options, const LightTrials& trials);

}  // namespace tress
