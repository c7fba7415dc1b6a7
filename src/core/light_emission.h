// SPDX-License-Identifier: MIT
// Light as it leaves a light towards a scene: where photons start, in which direction, and with what power.
#pragma once

#include "core/bounds.h"
#include "core/environment.h"
#include "core/light.h"

namespace tress {

/// All that light may meet lies inside.
struct Sphere {
    DVec3 center{0};
    double radius = 0;
};
/// About a box, grown a little so that none of its corners is outside by rounding. Of an empty box: radius 0.
Sphere sphere_about(const Bounds& bounds);

/// One way that light takes.
struct Emission {
    Vec3 position{0};  // at the light, or where the ray enters the sphere if the light is outside
    Vec3 direction{0, 0, 1};
    Rgb power{0};  // W, as if this were all of the light; its mean over u is the power that enters the sphere. 0: none
};

/// The most that a light is taken to emit, W, as kLargestIrradiance: sums and quotients of it stay finite.
inline constexpr float kLargestPower = 1e30f;

/// `u` is uniform in [0, 1)^4. Of one light all powers are equal, or 0 where the way misses the sphere or is thinned
/// out (a spot's soft rim); those of an environment differ as its picture does within a texel, those of a quad that
/// aims at the sphere by the cosine and by how near its parts are.
///   point: uniform in the cone about the sphere; all round from within it
///   spot: uniform in its own cone or in that about the sphere, the narrower, thinned by the falloff
///   distant: a disc as wide as the sphere, across the direction
///   quad: uniform over the area, on the side that shines; by the cosine, or uniform in the cone about the sphere where
///   that is narrower, the power then in proportion to the cosine
///   environment: a direction by brightness, then a disc across it
/// Lights that cannot send anything (black, no direction, no area) give power 0.
Emission emit(const PointLight& light, const Sphere& sphere, const glm::vec4& u);
Emission emit(const SpotLight& light, const Sphere& sphere, const glm::vec4& u);
Emission emit(const DistantLight& light, const Sphere& sphere, const glm::vec4& u);
Emission emit(const QuadLight& light, const Sphere& sphere, const glm::vec4& u);
Emission emit(const EnvironmentSampler& light, const Sphere& sphere, const glm::vec4& u);

/// Power of an emission that is not 0; of an environment, grey, the luminance of their mean; of a quad
/// that aims, about their mean. Photons are shared among
/// lights by its luminance, so that those that get to the sphere have equal luminance.
Rgb emission_power(const PointLight& light, const Sphere& sphere);
Rgb emission_power(const SpotLight& light, const Sphere& sphere);
Rgb emission_power(const DistantLight& light, const Sphere& sphere);
Rgb emission_power(const QuadLight& light, const Sphere& sphere);
Rgb emission_power(const EnvironmentSampler& light, const Sphere& sphere);

}  // namespace tress
