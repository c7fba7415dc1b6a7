// SPDX-License-Identifier: MIT
// Next-event estimation: one way to every light of a type from every point that the eye sees, through hair by its
// transmittance: Type 1 by shadow rays or by shadow maps, and the environment's part of Type 2 by shadow rays.
#pragma once

#include <span>
#include <vector>

#include "gather/lamp_visibility.h"
#include "gather/light_rays.h"

namespace tress {

class DirectLight {
public:
    /// Adds to radiance[i] the light that points[i] sends to the eye from `lights`; an environment gets
    /// options.gather.rays. `maps`: none: shadow rays all the
    /// way; environments have none.
    void operator()(const Scene& scene, const PreparedScene& prepared, const Options& options,
                    std::span<const uint32_t> lights, const LampMaps* maps, std::span<const ShadingPoint> points,
                    std::span<const Sampler> samplers, std::span<Rgb> radiance);

private:
    LightRays rays_;
    std::vector<Rgb> visibility_;
    LampVisibility query_;
};

}  // namespace tress
