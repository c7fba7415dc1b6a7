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

/// Views from one point of a lamp. One pinhole where all that is seen lies within a wide cone; where the lamp is among
/// the hair or close to it, up to six faces of a cube, those alone that see hair. Their rectangles are disjoint on the
/// sphere about the point. `resolution`: texels of the longer side of one view, or of a whole cube face.
struct LampViews {
    std::vector<LightView> views;
    bool complete = true;  // hair outside the views is none at all; false: some was left out because it is not seen
};

/// For a point (spot, quad) lamp: from `point` on it. Hair behind a quad's plane, and outside a spot's cone, is left
/// out.
LampViews fit_views(const Light& light, const DVec3& point, const SegmentView& segments, const SeenHair& seen,
                    int resolution);

/// Points of a lamp that get views of their own: grid x grid on a quad, cell by cell (first u.x, then u.y), jittered so
/// that no two share a row or a column of grid * grid (correlated multi-jittered, Kensler 2013); one for other lamps.
std::vector<DVec3> view_points(const Light& light, int grid);

/// Which of view_points a sample `u` of the lamp's area belongs to.
size_t view_point_of(const Light& light, int grid, const Vec2& u);

}  // namespace tress
