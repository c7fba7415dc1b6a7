// SPDX-License-Identifier: MIT
// A fiber's own image on a map: what it would shadow of itself where no ray is traced next to it.
#pragma once

#include "core/attenuation.h"
#include "core/segments.h"
#include "gather/shadow_maps/light_view.h"

namespace tress {

/// How far towards the light a map is asked, and what the answer is to be divided by.
struct OwnFiber {
    float radius;  // of the fiber, scene units: its axis is behind from there on
    Rgb passed;    // of the light through what of it a look-up still counts: its depth changes over the texels asked
};

/// Of a point on `segment` that falls at `at`; `to_light` is unit. `blur`: depth over which the map smears what lies at
/// one depth. Right on average: where a look-up happens to count
/// less of the fiber than it is divided by, more than all light is left, and cutting that off would darken the rest.
OwnFiber own_fiber(const SegmentView& hair, const Attenuation& attenuation, const LightView& view, const ViewPoint& at,
                   uint32_t segment, const Vec3& to_light, float blur);

}  // namespace tress
