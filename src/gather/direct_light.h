// SPDX-License-Identifier: MIT
// Next-event estimation: one shadow ray to every light of a type from every point that the eye sees, through hair by
// its transmittance (Type 1 by the method `ray`, and the environment's part of Type 2).
#pragma once

#include <span>
#include <vector>

#include "core/sampler.h"
#include "gather/shading_point.h"
#include "gather/visibility.h"

namespace tress {

/// Dimensions of the sampler that a light uses: lights start at kFirstLightDimension, each with three groups of its
/// own.
inline constexpr uint32_t kFirstLightDimension = kSobolGroup, kDimensionsALight = 3 * kSobolGroup;

class DirectLight {
public:
    /// Adds to radiance[i] the light that points[i] sends to the eye from `lights`.
    void operator()(const Scene& scene, const PreparedScene& prepared, const Options& options,
                    std::span<const uint32_t> lights, std::span<const ShadingPoint> points,
                    std::span<const Sampler> samplers, std::span<Rgb> radiance);

private:
    RayBuffer rays_;
    std::vector<uint32_t> point_of_ray_;
    std::vector<Rgb> unshadowed_, visibility_;
    VisibilityQuery query_;
};

}  // namespace tress
