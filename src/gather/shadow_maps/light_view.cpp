// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/light_view.h"

namespace tress {

ViewPoint project(const LightView& view, const Vec3& point) {
    const DVec3 from_origin = DVec3(point) - view.origin;
    const double z = dot(from_origin, DVec3(view.frame.z));
    const double scale = view.parallel ? 1 : 1 / z;
    const glm::dvec2 across(dot(from_origin, DVec3(view.frame.x)), dot(from_origin, DVec3(view.frame.y)));
    const glm::dvec2 at = (across * scale - view.low) / view.texel;
    return {float(at.x), float(at.y), float(z - view.start), view.parallel || z > 0};
}

}  // namespace tress
