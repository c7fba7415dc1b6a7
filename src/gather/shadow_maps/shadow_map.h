// SPDX-License-Identifier: MIT
// One view of a lamp with what its texels hold, of whatever kind.
#pragma once

#include <variant>

#include "core/options.h"
#include "gather/shadow_maps/cluster_texels.h"
#include "gather/shadow_maps/deep_texels.h"
#include "gather/shadow_maps/light_view.h"
#include "gather/shadow_maps/opacity_texels.h"

namespace tress {

struct ShadowMap {
    LightView view;
    std::variant<DeepTexels, OpacityTexels, ClusterTexels> texels;
};

/// Texels made in parallel; the same for any number of threads.
ShadowMap make_shadow_map(const LightView& view, MapKind kind, const SegmentView& segments,
                          const Attenuation& attenuation, const Options& options);

/// What is left of the light at a point of the view: the texels about it, bilinear.
Rgb transmittance(const ShadowMap& map, const ViewPoint& at);

/// Over how much depth light falls that one hair stops, scene units: the thickness of even layers; else 0 (those that
/// follow the hair are thin where it is lit).
float depth_blur(const ShadowMap& map);

size_t bytes(const ShadowMap& map);

}  // namespace tress
