// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/own_fiber.h"

namespace tress {
namespace {

/// Share of a look-up that a thin fiber through its middle covers, in fiber widths a texel: texels are boxes, look-ups
/// are bilinear, so the weights across the fiber are a quadratic B-spline, 3/4 high at its middle (0.78 for a fiber
/// along a diagonal).
constexpr float kMiddleWeight = 0.76f;

/// Share of the fiber before a point one radius before its axis: the weights of a look-up fall linearly over a texel to
/// either side, in which its depth changes by `rise`.
float own_share_before(float radius, float rise) { return rise > radius ? 0.5f * square(1 - radius / rise) : 0; }

}  // namespace

Rgb own_fiber_passed(const SegmentView& hair, const Attenuation& attenuation, const LightView& view,
                     const ViewPoint& at, uint32_t segment, const Vec3& to_light, float blur) {
    const Vec3 tangent(normalize(DVec3(hair.end(segment)) - DVec3(hair.start(segment))));
    const float along = std::min(std::abs(dot(tangent, to_light)), 1.0f), across = safe_sqrt(1 - along * along);
    const float width = fiber_width(hair, segment), texel = texel_width(view, at.depth);
    const float covered = std::min(1.0f, kMiddleWeight * width / texel);
    const float before = across > 0 ? own_share_before(0.5f * width, texel * along / across + blur) : 0.5f;
    return 1.0f - before * covered * (1.0f - exp(-attenuation.depth(segment, along)));
}

}  // namespace tress
