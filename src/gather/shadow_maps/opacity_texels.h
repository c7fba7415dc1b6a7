// SPDX-License-Identifier: MIT
// Opacity shadow maps (Kim & Neumann 2001): optical depth summed up to a few planes across the light, the same for all
// texels, linear between them; or to layers that follow the first hair of each texel (deep opacity maps, Yuksel &
// Keyser 2008).
#pragma once

#include <vector>

#include "core/math.h"
#include "core/options.h"
#include "gather/shadow_maps/hair_fragments.h"

namespace tress {

/// Optical depth before layer l of texel i ends: depth[c][i * layers + l]. Layers start at the texel's start and are
/// equally thick; behind the last the depth stays.
struct OpacityTexels {
    int layers = 0;
    float thickness = 0;          // of a layer, scene units
    float start = 0;              // of the first layer of every texel, unless they follow the hair
    std::vector<float> first;     // of the first hair of each texel, infinity: none; empty: layers are planes
    std::vector<float> depth[3];  // one channel, the others empty, where no fiber colours light
};

/// What layers have to span: depths of the nearest and the farthest hair of the view.
struct DepthRange {
    float nearest = 0, farthest = 0;
};

OpacityTexels make_opacity_texels(const FragmentTile& fragments, const OpacityOptions& options,
                                  const DepthRange& range);
void append(OpacityTexels& to, const OpacityTexels& tile);
Rgb transmittance(const OpacityTexels& texels, size_t texel, float depth);
size_t bytes(const OpacityTexels& texels);

}  // namespace tress
