// SPDX-License-Identifier: MIT
// How a fiber scatters a photon: f_R, followed from the light to the eye.
#pragma once

#include "core/fiber.h"
#include "core/sampler.h"

namespace tress {

/// Where a photon leaves a fiber. Directions are local to the fiber.
struct LeavingPhoton {
    Vec3 wo{0, 0, 1};
    float h = 0;    // offset as seen from wo, see fiber.h
    Rgb weight{0};  // f_R |cos theta_o| over the density of (wo, h); its mean is the albedo of f_R for light from wi
};

/// A photon that comes from `wi` and meets the fiber anywhere across its width. Every channel of the weight counts by
/// `color`. Uses the group of dimensions that starts at `dimension` and the next.
LeavingPhoton scatter_photon(const Fiber& fiber, const Rgb& sigma_a, const Vec3& wi, const Rgb& color,
                             const Sampler& sampler, uint32_t dimension);

}  // namespace tress
