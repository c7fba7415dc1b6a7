// SPDX-License-Identifier: MIT
// What a ray meets, by brute force in double precision on the same float inputs: what the tree's answers are held
// against. Everything that passes within a thousandth of a radius is listed, with how sure it is, so that a test can
// say which rays are too close to call.
#pragma once

#include <algorithm>
#include <vector>

#include "accel/queries.h"
#include "core/segments.h"

namespace tress::oracle {

/// Share of a radius within which single precision may decide either way.
inline constexpr double kEdge = 1e-3;

/// The ray's closest approach to the axis of a segment, its ends included.
struct Approach {
    uint32_t id;
    double t, u;
    double u_line;     // where the axis goes on past its ends
    double offset;     // of the ray from the axis there, in radii
    double sine;       // between ray and axis
    double tolerance;  // of t, from rounding: grows as ray and axis grow parallel
    double u_tolerance;
};

struct Ray {
    DVec3 origin, direction;
    double t_near, t_far;
};

inline Ray ray_of(const RayBatch& rays, size_t i) {
    return {DVec3(rays.ox[i], rays.oy[i], rays.oz[i]), DVec3(rays.dx[i], rays.dy[i], rays.dz[i]),
            double(rays.t_near[i]), double(rays.t_far[i])};
}

struct Segment {
    DVec3 start, axis;
    double radius, slope, reach;  // reach: a ball about the middle of the axis holds the segment
};

/// Segments made ready, and how large the scene is.
struct Scene {
    std::vector<Segment> segments;
    double extent = 0;

    explicit Scene(const SegmentView& view) {
        for (size_t i = 0; i < view.size(); ++i) {
            const DVec3 start(view.start(i)), axis = DVec3(view.end(i)) - start;
            const double r0 = view.start_radius(i), r1 = view.end_radius(i);
            segments.push_back({start, axis, r0, r1 - r0, 0.5 * length(axis) + 1.01 * std::max(r0, r1)});
        }
        const Bounds box = bounds(view);
        if (!box.empty()) extent = length(DVec3(box.extent()));
    }
};

/// Approaches within (1 + kEdge) radii, wherever on the line of the ray they are, in the order of t.
inline std::vector<Approach> approaches(const Scene& scene, const Ray& ray) {
    std::vector<Approach> found;
    const DVec3 d = ray.direction;
    const double dd = dot(d, d);
    for (size_t i = 0; i < scene.segments.size(); ++i) {
        const Segment& s = scene.segments[i];
        const DVec3 from_ray = s.start + 0.5 * s.axis - ray.origin;
        const double t_middle = dot(from_ray, d) / dd;
        const DVec3 middle = from_ray - t_middle * d;  // from the nearest point of the ray
        if (dot(middle, middle) > s.reach * s.reach) continue;
        const DVec3 a = middle - 0.5 * s.axis;
        const DVec3 a_across = a - d * (dot(a, d) / dd), v = s.axis - d * (dot(s.axis, d) / dd);
        const double vv = dot(v, v), sine = std::sqrt(vv / dot(s.axis, s.axis));
        const bool parallel = sine < 1e-9;  // met at the start of the axis, as the tree does below a sine of 1e-6
        const double u_line = parallel ? 0 : -dot(a_across, v) / vv;
        const double u = std::clamp(u_line, 0.0, 1.0);
        const double offset = length(a_across + u * v) / (s.radius + u * s.slope);
        if (!(offset <= 1 + kEdge)) continue;
        const double t = t_middle + dot(a + u * s.axis, d) / dd;
        // A few roundings of what is as large as the scene, and one of t itself.
        constexpr double kUlps = 16 * 0x1p-24;
        const double slip = kUlps * scene.extent / (parallel ? 1 : std::max(sine, 1e-6));
        found.push_back({uint32_t(i), t, u, u_line, offset, sine, slip / std::sqrt(dd) + kUlps * std::abs(t),
                         slip / length(s.axis) / (parallel ? 1 : std::max(sine, 1e-6))});
    }
    std::sort(found.begin(), found.end(), [](const Approach& a, const Approach& b) { return a.t < b.t; });
    return found;
}

/// Whether a crossing is one for certain, or for certain not; in between is too close to call.
inline bool surely(const Approach& a, const Ray& ray, bool open_ends) {
    const double u = open_ends ? a.u_tolerance : -1e30;
    return a.offset <= 1 - kEdge && a.t >= ray.t_near + a.tolerance && a.t < ray.t_far - a.tolerance && a.u_line >= u &&
           a.u_line <= 1 - u;
}
inline bool possibly(const Approach& a, const Ray& ray, bool open_ends) {
    const double u = open_ends ? a.u_tolerance : 1e30;
    return a.t >= ray.t_near - a.tolerance && a.t < ray.t_far + a.tolerance && a.u_line >= -u && a.u_line <= 1 + u;
}

}  // namespace tress::oracle
