// SPDX-License-Identifier: MIT
// A segment as a view sees it: a flat ribbon about its axis that faces the light. In texels it runs along its major
// axis; along the other one it is as wide at each place as a linear function says (what is linear on the segment and
// divided by z is linear in the view).
#pragma once

#include <array>
#include <optional>

#include "core/segments.h"
#include "gather/shadow_maps/light_view.h"

namespace tress {

/// Texels [low, high).
struct TexelRect {
    glm::ivec2 low, high;
};

/// Widest thin ribbon, from its axis, texels: its ends are wrong by at most 1/32 of a texel's area.
inline constexpr double kThin = 0.25;

struct Ribbon {
    /// thin: narrower than a texel; it ends along the minor axis, which moves no more than half_width^2 / 2 of a
    /// texel's area an end. wide: a quadrilateral. dot: the axis runs along the light, and what is seen is a disc.
    enum class Shape { thin, wide, dot };
    Shape shape;
    int major;              // 0: it runs along x, 1: along y; the ends are in that order
    glm::dvec2 at[2];       // ends of the axis, texels
    double z[2];            // of the ends, in the view's frame
    double half_width[2];   // at the ends, along the minor axis, texels; not of a dot
    double radius[2];       // scene units
    DVec3 end[2], tangent;  // in the view's frame, from its origin; tangent: unit
};

/// None where nothing can be seen of it. Of a pinhole's, what is nearer along z than kNearRadii of its radius is left
/// out: there the lamp touches the fiber.
inline constexpr double kNearRadii = 2;
std::optional<Ribbon> make_ribbon(const LightView& view, const SegmentView& segments, uint32_t segment);

/// z of the axis at a place between its ends, 0 to 1 in the view.
double z_at(const LightView& view, const Ribbon& ribbon, double place);

/// Corners of what is seen of a ribbon that is not thin, in texels, in order.
struct RibbonOutline {
    static constexpr int kMost = 16;
    std::array<glm::dvec2, kMost> corner;
    int corners = 0;
};
RibbonOutline outline(const LightView& view, const Ribbon& ribbon);

/// |sin(theta)| of the fiber to the light through a place of the view, in texels.
double abs_sin_theta(const LightView& view, const Ribbon& ribbon, const glm::dvec2& place);

}  // namespace tress
