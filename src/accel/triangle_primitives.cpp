// SPDX-License-Identifier: MIT
#include "accel/triangle_primitives.h"

#include <tbb/parallel_for.h>

namespace tress {
namespace {

constexpr size_t kGrain = 16384;
constexpr size_t kMostCorners = 9;  // a triangle cut by six planes gains at most one corner a plane

struct Polygon {
    std::array<DVec3, kMostCorners> corner;
    size_t corners = 0;

    void add(const DVec3& p) { corner[corners++] = p; }
};

/// Part of `polygon` where side * (p[axis] - plane) >= 0 (Sutherland & Hodgman 1974).
Polygon clip_to_plane(const Polygon& polygon, int axis, double plane, double side) {
    Polygon kept;
    for (size_t i = 0; i < polygon.corners; ++i) {
        const DVec3& p = polygon.corner[i];
        const DVec3& next = polygon.corner[i + 1 < polygon.corners ? i + 1 : 0];
        const double from = side * (p[axis] - plane), to = side * (next[axis] - plane);
        if (from >= 0) kept.add(p);
        if ((from < 0) != (to < 0)) kept.add(p + (next - p) * (from / (from - to)));
    }
    return kept;
}

}  // namespace

TrianglePrimitives::TrianglePrimitives(const TriangleMesh& mesh, const DVec3& origin) : corners_(mesh.triangles()) {
    tbb::parallel_for(tbb::blocked_range<size_t>(0, corners_.size(), kGrain), [&](const auto& range) {
        for (size_t t = range.begin(); t < range.end(); ++t)
            for (size_t k = 0; k < 3; ++k) corners_[t][k] = Vec3(DVec3(mesh.triangle(t)[k]) - origin);
    });
    for (const auto& triangle : corners_)
        for (const Vec3& p : triangle) padding_ = std::max(padding_, kPadding * largest_coordinate(p));
}

Reference TrianglePrimitives::reference(uint32_t id) const {
    DBounds box;
    for (const Vec3& p : corners_[id]) box.add(DVec3(p));
    return {Vec3(box.lo - padding_), Vec3(box.hi + padding_), id};
}

bool TrianglePrimitives::clip(Reference& part) const {
    Polygon polygon;
    for (const Vec3& p : corners_[part.id]) polygon.add(DVec3(p));
    for (int k = 0; k < 3; ++k) {
        polygon = clip_to_plane(polygon, k, part.lo[k] - padding_, 1);
        polygon = clip_to_plane(polygon, k, part.hi[k] + padding_, -1);
    }
    DBounds box;
    for (size_t i = 0; i < polygon.corners; ++i) box.add(polygon.corner[i]);
    part.lo = max(part.lo, Vec3(box.lo - padding_));
    part.hi = min(part.hi, Vec3(box.hi + padding_));
    return polygon.corners > 0 && !Bounds{part.lo, part.hi}.empty();
}

}  // namespace tress
