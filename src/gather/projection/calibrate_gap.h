// SPDX-License-Identifier: MIT
// How much of the gaps between cells must be added (CellLight), found by rays; and what error is left.
#pragma once

#include "gather/prepared_scene.h"

namespace tress {

/// Compares the mean transmittance about some points of hair that the eye sees with rays. Where options say that rays
/// choose the gap, sets it so that no bias is left; sets prepared.projection.error in any case.
void calibrate_gap(const Scene& scene, PreparedScene& prepared, const Options& options);

}  // namespace tress
