// SPDX-License-Identifier: MIT
// Sampling of lights that have a place or a direction. The environment has environment.h.
#pragma once

#include "core/light.h"

namespace tress {

/// One direction towards a light from a point, and what comes along it if nothing is in the way.
struct LightSample {
    Vec3 direction{0, 0, 1};  // unit
    float distance = 0;       // to the light; infinity for distant lights and the environment
    Rgb irradiance{0};        // radiance / pdf, so that f |cos| irradiance is the estimate; 0: no light here
    float pdf = 0;            // 1 / steradian; 0: no ray would meet the light but by aiming at it
    Vec2 place{0};            // of a quad: where on it, in shares of its edges
};

/// Largest irradiance kept: a light of 1e30 W/sr, or one at distance 1e-20, stays finite down to the film.
inline constexpr float kLargestIrradiance = 1e30f;

LightSample sample(const PointLight& light, const Vec3& point, const Vec2& u);
LightSample sample(const SpotLight& light, const Vec3& point, const Vec2& u);
LightSample sample(const DistantLight& light, const Vec3& point, const Vec2& u);
/// Uniform over the area from far away, so that `place` is `u`. From near (nearer to the lamp's middle than its longer
/// diagonal) uniform over the solid angle, where samples of the area would be without bound as the point approaches the
/// lamp. No irradiance thus exceeds 2 pi times the radiance: from far, no point of the lamp is nearer than half that
/// diagonal, and the area is at most half its square.
LightSample sample(const QuadLight& light, const Vec3& point, const Vec2& u);

/// What a spot sends along the unit vector `from_light`, as a share of its intensity: 1 inside the cone, falling
/// smoothly to 0 over its outer tenth.
double spot_falloff(const SpotLight& light, const DVec3& from_light);

/// Where a ray passes through a lamp that has an area.
struct LampHit {
    float distance = kInfinity;  // infinity: nowhere, or from its dark side
    Rgb radiance{0};
    float pdf = 0;  // 1 / steradian, with which sample() from the ray's origin draws its direction
};
/// `direction` is unit.
LampHit hit(const QuadLight& light, const Vec3& origin, const Vec3& direction);

}  // namespace tress
