// SPDX-License-Identifier: MIT
// The paper's simplified hair model (Yuksel, Akleman & Keyser 2007, sec. 4.2): a share of the strands, each of fewer
// segments.
#pragma once

#include "core/options.h"
#include "core/segments.h"
#include "gather/projection/projected_segments.h"

namespace tress {

/// Strands drawn by hash with the chance options.share; options.stride segments one after another become one. Weighted,
/// what is kept is as wide as all that it stands for.
ProjectedSegments simplify_hair(const SegmentView& segments, const ProjectionOptions& options);

}  // namespace tress
