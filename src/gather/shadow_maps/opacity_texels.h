// SPDX-License-Identifier: MIT
// Opacity shadow maps (Kim & Neumann 2001): optical depth summed up to a few planes across the light, the same for all
// texels, linear between them; or to layers that follow the first hair of each texel (deep opacity maps, Yuksel &
// Keyser 2008).
#pragma once

#include <cstdint>
#include <vector>

#include "core/math.h"
#include "core/options.h"
#include "gather/shadow_maps/hair_fragments.h"
#include "gather/shadow_maps/texel_rows.h"

namespace tress {

/// Optical depth before layer l of row r ends: total[c][r] * level[c][r * layers + l] / kFullLevel; 0 where the first
/// layer starts; behind the last it stays `total`. Levels are rounded: to kOpaqueDepth / 2 / kFullLevel = 4e-4 at most.
///
/// Layers of all texels span the same. Planes are at equal distances. Layers that follow the hair grow evenly away from
/// the light, as 1 : 3 : 5 ..., since most light is lost in the first ones (the paper leaves sizes to the user, and
/// lets them grow). On random hair spread evenly, in two shells or thinning out, 32 of them err 0.4 to 1 times as much
/// as even ones, 8 of them 0.25 to 1.3 times. As they span all there is, no hair lies behind the last.
struct OpacityTexels {
    static constexpr uint16_t kFullLevel = 65535;
    int layers = 0;
    float span = 0;                  // of all layers, scene units
    float start = 0;                 // of the first layer of every texel, unless they follow the hair
    TexelRows rows;                  // of the texels
    std::vector<float> first;        // depth of the first hair, one a row; empty: layers are planes
    std::vector<float> total[3];     // one a row, at most kOpaqueDepth; one channel where no fiber colours light
    std::vector<uint16_t> level[3];  // as many channels
};

/// What layers have to span: depths of the nearest and the farthest hair of the view.
struct DepthRange {
    float nearest = 0, farthest = 0;
};

/// Hair outside the range, by rounding or otherwise, counts in the first or the last layer.
OpacityTexels make_opacity_texels(const FragmentTile& fragments, const OpacityOptions& options,
                                  const DepthRange& range);

/// `tile` must have been made with the same options and range. Onto a default-made `to`, a copy.
void append(OpacityTexels& to, const OpacityTexels& tile);

/// 1 before the first layer and for a depth that is no number.
Rgb transmittance(const OpacityTexels& texels, size_t texel, float depth);

size_t bytes(const OpacityTexels& texels);

}  // namespace tress
