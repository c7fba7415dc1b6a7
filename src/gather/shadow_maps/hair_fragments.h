// SPDX-License-Identifier: MIT
// Hair projected into the texels of a view. A hair is thinner than a texel most often: it covers a fraction c of it,
// and stops c (1 - a) of the light that goes through the texel there (a: attenuation.h, at the inclination of the fiber
// to the light). Wider hair covers the texels it lies over whole.
#pragma once

#include <functional>
#include <vector>

#include "core/attenuation.h"
#include "core/segments.h"
#include "gather/shadow_maps/light_view.h"

namespace tress {

/// Fragments of the kViewTile x kViewTile texels of one tile: those of texel i, in the order of depth (ties: the order
/// of segments), are first[i] .. first[i + 1] - 1.
struct FragmentTile {
    std::vector<uint32_t> first;
    std::vector<float> depth;       // of the hair's axis, mean over the texel; from the view's plane of depth 0
    std::vector<float> opacity[3];  // c (1 - a) in [0, 1]; one channel, the others empty, where no fiber colours light
};

/// Whether a_k differs between channels anywhere.
bool colors_light(const Attenuation& attenuation);

/// Calls `take(tile, fragments)` once for every tile of the view, in parallel and in any order; `tile` counts as
/// texel_index does. Texels whose light is below `opaque` in every channel are: fragments behind may be left out. The
/// fragments are the same whatever the number of threads; `take` may keep or change them. Left out are
/// segments nearer to a pinhole than their own width, and what of hair is nearer along z.
void project_hair(const LightView& view, const SegmentView& segments, const Attenuation& attenuation, float opaque,
                  const std::function<void(int tile, FragmentTile& fragments)>& take);

}  // namespace tress
