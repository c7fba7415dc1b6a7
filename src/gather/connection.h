// SPDX-License-Identifier: MIT
// Straight ways from points to lights.
#pragma once

#include "core/light_sample.h"
#include "gather/shading_point.h"

namespace tress {

/// A way from a point to a light, and the light that it would bring to the eye with nothing between.
struct Connection {
    Vec3 direction{0, 0, 1};
    float distance = 0;
    Rgb radiance{0};
    Vec2 place{0};  // of a quad: where on it, in shares of its edges
};

/// Kept finite: two factors near the largest floats may overflow.
inline Rgb bounded(const Rgb& radiance) { return min(radiance, Rgb(kLargestIrradiance)); }

/// A lamp may lie in a polygon's plane, as in a ceiling: a ray towards it stops short of it by the rounding of both
/// ends.
float short_of(const Vec3& point, float distance);

/// `light` seen from `point`; nothing of an environment, which environment.h samples. `u` is uniform in [0, 1)^2.
LightSample sample_lamp(const Light& light, const Vec3& point, const Vec2& u);

/// One direction from `origin` towards a light of any kind; its distance stops short of the lamp.
LightSample sample_light(const Scene& scene, const PreparedScene& prepared, uint32_t light, const Vec3& origin,
                         const Vec2& u);

/// Black where the lamp brings nothing.
Connection connect_lamp(const Scene& scene, const ShadingPoint& point, const Light& light, const Vec2& u);

}  // namespace tress
