// SPDX-License-Identifier: MIT
// A fiber's own image on a map: what it would shadow of itself where no ray is traced next to it.
#pragma once

#include "core/attenuation.h"
#include "core/segments.h"
#include "gather/shadow_maps/light_view.h"

namespace tress {

/// Of a segment at its start, scene units.
inline float fiber_width(const SegmentView& hair, uint32_t segment) { return 2 * hair.start_radius(segment); }

/// What a map asked one radius towards the light is to be divided by: the light through what of the fiber the look-up
/// counts all the same, as its depth changes over the texels asked, and over `blur`, the depth over which the map
/// smears what lies at one depth. For a point on `segment`, thinner than a texel, that falls at `at`; `to_light` is
/// unit. Right on average: where a look-up happens to count less, more than all light is left, and cutting that off
/// would darken the rest.
Rgb own_fiber_passed(const SegmentView& hair, const Attenuation& attenuation, const LightView& view,
                     const ViewPoint& at, uint32_t segment, const Vec3& to_light, float blur);

}  // namespace tress
