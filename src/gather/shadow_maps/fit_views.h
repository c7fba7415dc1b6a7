// SPDX-License-Identifier: MIT
// Views from lamps, fitted to the hair that matters: what hair stands between a lamp and the points that the eye sees
// lies in the cone (or the beam) from the lamp through those points.
#pragma once

#include <span>
#include <vector>

#include "core/light.h"
#include "core/segments.h"
#include "gather/shadow_maps/light_view.h"

namespace tress {

/// What views are fitted to.
struct SeenHair {
    Bounds bounds;             // of all hair, radii included
    std::vector<Vec3> points;  // on hair that the eye sees, spread over the picture; empty: all hair counts as seen
};

/// Views from one point of a lamp: no, one or several. One pinhole where all that is seen lies within a wide cone in
/// front of it; where the lamp is among the hair or close to it, up to six faces of a cube, those alone that see hair.
/// Any direction lies in one of them at most, but for rounding: where faces meet, in that one which has the border on
/// its low side (contains() is half-open). Nothing that is seen lies outside, but for the very lamp's point and two of
/// the eight corners of a cube, (1, 1, 1) and (-1, -1, -1) of its axes, which are in no face.
struct LampViews {
    std::vector<LightView> views;
    bool complete = true;  // no lit hair lies outside the views; false: some may, because it is not seen
};

/// For a point (spot, quad) lamp: from `point` on it; a distant light has one parallel view, an environment none. Hair
/// that is not lit does not count: behind a quad's plane, outside a spot's cone. `resolution`: texels of the longer
/// side of one view, or of a whole cube face, of which a view may be a part; texels are square.
LampViews fit_views(const Light& light, const DVec3& point, const SegmentView& segments, const SeenHair& seen,
                    int resolution);

/// Points of a lamp that get views of their own: grid x grid on a quad, one in each cell, row by row (u.x runs first),
/// jittered so that no two share their u.x or their u.y (correlated multi-jittered, Kensler 2013); one for other lamps.
std::vector<DVec3> view_points(const Light& light, int grid);

/// Which of view_points a sample `u` of the lamp's area, as sample() takes it, belongs to.
size_t view_point_of(const Light& light, int grid, const Vec2& u);

}  // namespace tress
