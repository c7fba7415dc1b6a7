// SPDX-License-Identifier: MIT
// Light from infinitely far all round, ready to be looked up and sampled. Orientation as in light.h. A rotation by
// +90 degrees about +y (right-handed) takes what was seen towards -z to -x. Texels are interpolated bilinearly,
// across the seam too; at the poles the last row goes on.
//
// Sampling: a texel is chosen by the luminance that the interpolated picture has on average over it times its solid
// angle, then a direction in it uniformly by solid angle. So the density is one number a texel, finite at the poles,
// and positive wherever there is radiance, also beside a bright texel.
#pragma once

#include <cstdint>
#include <vector>

#include "core/light.h"

namespace tress {

struct EnvironmentSampler {
    Image image;  // radiance, the factor multiplied in; empty: `constant` everywhere
    Rgb constant{0};
    double sin_rotation = 0, cos_rotation = 1;
    uint64_t bad_texels = 0;       // not finite, negative, or too large with the factor: taken as black
    double power = 0;              // luminance over the sphere, of the density: 0 where all is black
    std::vector<double> row_cdf;   // height + 1, from 0 to 1
    std::vector<double> cell_cdf;  // height x (width + 1), each row from 0 to 1 (or all 0 where black)
    std::vector<double> cos_edge;  // height + 1: cosine to +y of the upper edge of each row, and of the last lower one
};

EnvironmentSampler make_environment_sampler(Image image, const Rgb& factor, double rotation_degrees);
/// Constant where the light has no image.
EnvironmentSampler make_environment_sampler(const EnvironmentLight& light);

inline size_t bytes(const EnvironmentSampler& e) {
    return e.image.pixel.capacity() * sizeof(Rgb) +
           (e.row_cdf.capacity() + e.cell_cdf.capacity() + e.cos_edge.capacity()) * sizeof(double);
}

/// Radiance that arrives from the unit vector `direction`.
Rgb radiance(const EnvironmentSampler& environment, const Vec3& direction);

struct EnvironmentSample {
    Vec3 direction{0, 1, 0};
    Rgb radiance{0};
    float pdf = 0;  // 1 / steradian; 0: nothing to sample
};
/// `u` is uniform in [0, 1)^2.
EnvironmentSample sample_environment(const EnvironmentSampler& environment, const Vec2& u);
/// The density with which sample_environment chooses `direction`, a unit vector.
float pdf_environment(const EnvironmentSampler& environment, const Vec3& direction);

}  // namespace tress
