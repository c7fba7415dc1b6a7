// SPDX-License-Identifier: MIT
// A part of a view that is wanted, and the hair found in it.
#pragma once

#include <span>
#include <vector>

#include "core/segments.h"
#include "gather/shadow_maps/light_view.h"
#include "gather/shadow_maps/lit_cone.h"

namespace tress {

/// Rectangles of one view, each within those before it, but for `reach`.
struct HairWindow {
    LightView view;        // origin and frame alone hold
    ViewRectangle limits;  // of the view: a face of a cube, or everywhere
    ViewRectangle lit;     // what the lamp shines into of it
    ViewRectangle wanted;  // hair outside counts as left out
    ViewRectangle reach;   // what texels may cover: a little more than `wanted`
};

struct HairFound {
    ViewRectangle hair;                                        // of lit hair, within `wanted`
    double nearest = std::numeric_limits<double>::infinity();  // smallest z of any hair within `reach`
};

/// One row a window; windows are of one point (or direction), and their limits do not overlap.
struct HairSearch {
    std::vector<HairFound> found;
    bool left_out = false;  // lit hair lies in no window
};
HairSearch find_hair(std::span<const HairWindow> windows, const LitCone& cone, const SegmentView& segments);

/// A segment as a view sees it.
ViewHair in_view(const LightView& view, const SegmentView& segments, size_t segment);

inline Projection projection_of(const LightView& view) {
    return view.parallel ? Projection::parallel : Projection::pinhole;
}

/// A ball about a segment, or about segments [first, last).
struct HairBall {
    DVec3 center;
    double radius;
};
HairBall ball_about(const SegmentView& segments, size_t segment);
HairBall ball_about(const SegmentView& segments, size_t first, size_t last);

}  // namespace tress
