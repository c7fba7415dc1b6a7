// SPDX-License-Identifier: MIT
// Ways from points to one light, drawn as next-event estimation draws them.
#pragma once

#include <span>
#include <vector>

#include "core/sampler.h"
#include "gather/lamp_visibility.h"
#include "gather/shading_point.h"

namespace tress {

/// Dimensions of the sampler that a light uses: lights start at kFirstLightDimension, each with three groups of its
/// own.
inline constexpr uint32_t kFirstLightDimension = kSobolGroup, kDimensionsALight = 3 * kSobolGroup;

/// Rows belong together by index. A ray ends at its lamp.
struct LightRays {
    LampRays to;
    std::vector<uint32_t> point;  // that it starts from
    std::vector<Rgb> unshadowed;  // light that the point would send to the eye, were nothing between; / rays a point

    size_t size() const { return to.size(); }
};

/// `rays` from every point, in place of those from before; those that can bring no light are left out.
void make_light_rays(const Scene& scene, const PreparedScene& prepared, uint32_t light, uint32_t rays,
                     std::span<const ShadingPoint> points, std::span<const Sampler> samplers, LightRays& made);

}  // namespace tress
