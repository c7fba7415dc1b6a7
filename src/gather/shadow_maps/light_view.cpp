// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/light_view.h"

namespace tress {
namespace {

/// A texel coordinate as float, on the same side of both ends of [0, size) as it is in double.
float texel_coordinate(double value, int size) {
    constexpr double farthest = 1e30;  // that float should hold; nothing looks there
    const float rounded = float(glm::clamp(value, -farthest, farthest));
    return value < size && rounded == float(size) ? std::nextafter(rounded, 0.0f) : rounded;
}

}  // namespace

ViewPoint project(const LightView& view, const Vec3& point) {
    const DVec3 p = to_local(view, DVec3(point));
    if (!view.parallel && !(p.z > 0)) return {};
    const glm::dvec2 at = (glm::dvec2(p) / (view.parallel ? 1 : p.z) - view.low) / view.texel;
    return {texel_coordinate(at.x, view.width), texel_coordinate(at.y, view.height), float(p.z - view.start), true};
}

Vec3 light_direction(const LightView& view, float x, float y) {
    if (view.parallel) return view.frame.z;
    const glm::dvec2 at = view.low + glm::dvec2(x, y) * view.texel;
    const Frame& f = view.frame;
    return Vec3(normalize(at.x * DVec3(f.x) + at.y * DVec3(f.y) + DVec3(f.z)));
}

float texel_width(const LightView& view, float depth) {
    const double side = glm::max(view.texel.x, view.texel.y);
    return float(view.parallel ? side : side * glm::max(view.start + double(depth), 0.0));
}

}  // namespace tress
