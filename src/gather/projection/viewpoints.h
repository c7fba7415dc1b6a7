// SPDX-License-Identifier: MIT
// How the igloo stands about a point that is shaded.
#pragma once

#include "gather/projection/cell_depths.h"
#include "gather/shading_point.h"

namespace tress {

/// Any way round.
Frame turned_at_random(uint64_t key);

/// Turned at random by `key` (where points share no far hair), so that what error the cells leave is noise and no
/// pattern: about the normal at a polygon, any way round at a fiber.
Viewpoint viewpoint_of(const ShadingPoint& point, uint64_t key);

/// The fiber's own segments.
Unseen unseen_from(const ShadingPoint& point, const SegmentView& segments);

}  // namespace tress
