// SPDX-License-Identifier: MIT
// The directions that a point of a lamp shines in: all round, a spot's cone, or a quad's half space.
#pragma once

#include <optional>

#include "core/light.h"
#include "gather/shadow_maps/view_rectangle.h"

namespace tress {

struct LitCone {
    DVec3 apex{0}, axis{0, 0, 1};
    double sine = 0, cosine = -1;  // of the angle between the axis and the surface

    /// Whether any of a ball may be lit. Balls near the apex and behind it may count though they are not.
    bool reaches(const DVec3& center, double radius) const {
        if (cosine == -1) return true;
        const DVec3 v = center - apex;
        const double along = dot(v, axis);
        const double across = safe_sqrt(dot(v, v) - along * along);
        return across * cosine - along * sine <= radius;
    }
};

/// Of a point on a point lamp, spot or quad. None where the lamp shines nowhere: a quad without an area.
std::optional<LitCone> lit_cone(const Light& light, const DVec3& point);

/// What the cone fills of a pinhole that looks along z; `axis` is the cone's, in the pinhole's frame.
ViewRectangle rectangle_of(const LitCone& cone, const DVec3& axis);

}  // namespace tress
