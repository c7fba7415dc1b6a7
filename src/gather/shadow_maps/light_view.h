// SPDX-License-Identifier: MIT
// How hair looks from a point of a lamp, or along a distant lamp's light: a rectangle of texels and a depth.
#pragma once

#include <cstdint>

#include "core/frame.h"
#include "core/math.h"

namespace tress {

/// A pinhole at a lamp's point, or a parallel view along a lamp's light. A straight way to the lamp is one texel
/// position, whatever the depth.
struct LightView {
    DVec3 origin{0};  // pinhole: the lamp's point; parallel: any point
    Frame frame;      // z: the way the light goes through the middle of the view
    bool parallel = false;
    double start = 0;             // distance of `origin` along z to the plane of depth 0: no hair lies before it
    glm::dvec2 low{0}, texel{1};  // pinhole: x / z and y / z of the corner, and a texel's size in them; parallel: x, y
    int width = 0, height = 0;    // texels
};

/// A point in the view's frame, from its origin: in double, since a lamp may be a great many scene sizes away.
inline DVec3 to_local(const LightView& view, const DVec3& point) {
    const DVec3 v = point - view.origin;
    return {dot(v, DVec3(view.frame.x)), dot(v, DVec3(view.frame.y)), dot(v, DVec3(view.frame.z))};
}

/// Where a point falls: x in [0, width), y in [0, height) inside the view, in texels; depth along z from its plane of
/// depth 0, scene units.
struct ViewPoint {
    float x = 0, y = 0, depth = 0;
    bool in_front = false;  // of a pinhole; false: nothing else holds
};
ViewPoint project(const LightView& view, const Vec3& point);

/// Half-open: of two views that share a border one contains it. Rounding to float takes nothing out at the far sides.
inline bool contains(const LightView& view, const ViewPoint& p) {
    return p.in_front && p.x >= 0 && p.y >= 0 && p.x < float(view.width) && p.y < float(view.height);
}

/// Direction of the light through a place of the view, unit; places outside are fine.
Vec3 light_direction(const LightView& view, float x, float y);

/// Width of a texel at a depth, across the view's z, scene units: the larger of its two sides. Never negative.
float texel_width(const LightView& view, float depth);

/// Texels are kept tile by tile, each row by row, so that those near one another in the view are so in memory. Tiles at
/// the right and upper edge are kept whole.
inline constexpr int kViewTile = 32;  // texels a side

inline int tiles_across(const LightView& view) { return (view.width + kViewTile - 1) / kViewTile; }
inline int tiles_down(const LightView& view) { return (view.height + kViewTile - 1) / kViewTile; }
inline int tile_count(const LightView& view) { return tiles_across(view) * tiles_down(view); }

/// Place of texel (x, y) in that order. The texel must be in the view.
inline size_t texel_index(const LightView& view, int x, int y) {
    const int tile = y / kViewTile * tiles_across(view) + x / kViewTile;
    const int within = y % kViewTile * kViewTile + x % kViewTile;
    return size_t(tile) * (kViewTile * kViewTile) + size_t(within);
}

}  // namespace tress
