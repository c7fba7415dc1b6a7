// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/ribbon.h"

#include <limits>
#include <utility>

namespace tress {
namespace {

/// Sine between axis and light below which the hair tree takes them for parallel (accel/segment_test-inl.h).
constexpr double kParallel = 1e-6;

DVec3 local(const LightView& view, const Vec3& point) {
    const DVec3 p = DVec3(point) - view.origin;
    return {dot(p, DVec3(view.frame.x)), dot(p, DVec3(view.frame.y)), dot(p, DVec3(view.frame.z))};
}

glm::dvec2 texels(const LightView& view, const DVec3& p) {
    const double scale = view.parallel ? 1 : 1 / p.z;
    return (glm::dvec2(p) * scale - view.low) / view.texel;
}

/// Of the axis to the pinhole: a fiber that a lamp lies in or on would be seen end on, and stop its light both ways.
double distance_to_origin(const Ribbon& r) {
    const DVec3 axis = r.end[1] - r.end[0];
    const double u = glm::clamp(-dot(r.end[0], axis) / dot(axis, axis), 0.0, 1.0);
    return glm::length(r.end[0] + u * axis);
}

/// Cuts off what lies before z = near; false where nothing remains.
bool clip(Ribbon& r, double near) {
    if (!(r.end[0].z > near || r.end[1].z > near)) return false;
    for (int k = 0; k < 2; ++k) {
        if (r.end[k].z >= near) continue;
        const double u = (near - r.end[k].z) / (r.end[1 - k].z - r.end[k].z);
        r.end[k] += u * (r.end[1 - k] - r.end[k]);
        r.end[k].z = near;
        r.radius[k] += u * (r.radius[1 - k] - r.radius[k]);
    }
    return true;
}

/// Whether the axis runs along the light, as far as floats of the size of `largest` can tell.
bool is_dot(const LightView& view, const Ribbon& r, const DVec3& axis, double largest) {
    const DVec3 middle = 0.5 * (r.end[0] + r.end[1]);
    const DVec3 light = view.parallel ? DVec3(0, 0, 1) : middle;
    const DVec3 across = cross(axis, light);
    constexpr double kUlp = 0x1p-23;
    const double least = std::max(square(kParallel) * dot(axis, axis), square(kUlp * largest));
    return !(dot(across, across) > least * dot(light, light));
}

/// Half widths along the minor axis. A ray d touches the ribbon where |d . n| = r |d x axis|, n = axis x end; on the
/// axis |d x axis| = |n| / z, so in y it is |n| / |n_y| r / z; n is (-slope, 1, slope x - y) up to a factor.
void set_half_widths(const LightView& view, Ribbon& r) {
    const int major = r.major, minor = 1 - major;
    const glm::dvec2 along = (r.at[1] - r.at[0]) * view.texel;
    const double slope = along[minor] / along[major];
    double squared = 1 + slope * slope;
    if (!view.parallel) squared += square((r.end[0][minor] - slope * r.end[0][major]) / r.z[0]);
    const double scale = std::sqrt(squared) / view.texel[minor];
    for (int k = 0; k < 2; ++k) r.half_width[k] = r.radius[k] * scale / (view.parallel ? 1 : r.z[k]);
}

/// Half width of a flat ribbon through the axis, `away` from the light, that stops the rays which pass within `radius`
/// of the axis: they make an angle of at most asin(radius / away) with it.
double seen_radius(double radius, double away) {
    constexpr double kWidestSine = 0.9;
    const double sine = std::min(radius / away, kWidestSine);
    return radius / std::sqrt(1 - sine * sine);
}

}  // namespace

std::optional<Ribbon> make_ribbon(const LightView& view, const SegmentView& segments, uint32_t segment) {
    Ribbon r;
    const Vec3 start = segments.start(segment), end = segments.end(segment);
    r.radius[0] = segments.start_radius(segment), r.radius[1] = segments.end_radius(segment);
    const double widest = std::max(r.radius[0], r.radius[1]);
    if (!(widest > 0) || !(std::min(r.radius[0], r.radius[1]) >= 0) || !std::isfinite(widest)) return {};
    r.end[0] = local(view, start), r.end[1] = local(view, end);
    const DVec3 axis = r.end[1] - r.end[0];
    const double squared_length = dot(axis, axis);
    if (!std::isfinite(squared_length) || !(squared_length > 0)) return {};
    r.tangent = axis / std::sqrt(squared_length);
    const double near = kNearRadii * widest;
    if (!view.parallel && (distance_to_origin(r) < near || !clip(r, near))) return {};

    for (int k = 0; k < 2; ++k) r.at[k] = texels(view, r.end[k]), r.z[k] = r.end[k].z;
    const glm::dvec2 along = abs(r.at[1] - r.at[0]);
    if (!std::isfinite(along.x + along.y)) return {};
    r.major = along.y > along.x;
    const double largest = std::max(max_component(abs(start)), max_component(abs(end)));
    if (!(along[r.major] > 0) || is_dot(view, r, r.end[1] - r.end[0], largest)) {
        r.shape = Ribbon::Shape::dot;
        r.half_width[0] = r.half_width[1] = 0;
        return r;
    }
    if (r.at[0][r.major] > r.at[1][r.major]) {
        std::swap(r.at[0], r.at[1]), std::swap(r.z[0], r.z[1]);
        std::swap(r.end[0], r.end[1]), std::swap(r.radius[0], r.radius[1]);
    }
    set_half_widths(view, r);
    r.shape = std::max(r.half_width[0], r.half_width[1]) <= kThin ? Ribbon::Shape::thin : Ribbon::Shape::wide;
    return r;
}

double z_at(const LightView& view, const Ribbon& r, double place) {
    if (view.parallel) return r.z[0] + place * (r.z[1] - r.z[0]);
    return r.z[0] * r.z[1] / (r.z[1] + place * (r.z[0] - r.z[1]));  // 1 / z is linear
}

RibbonOutline outline(const LightView& view, const Ribbon& r) {
    RibbonOutline o;
    const DVec3 middle = 0.5 * (r.end[0] + r.end[1]);
    const DVec3 light = view.parallel ? DVec3(0, 0, 1) : normalize(middle);
    if (r.shape == Ribbon::Shape::dot) {
        // A polygon as large as the disc, seen at its nearer end.
        const Frame facing = frame_about(Vec3(light));
        const int nearer = r.z[1] < r.z[0];
        const double step = 2 * double(kPi) / RibbonOutline::kMost;
        const double size = r.radius[nearer] * std::sqrt(step / std::sin(step));
        for (int k = 0; k < RibbonOutline::kMost; ++k) {
            const double angle = step * (k + 0.5);
            const DVec3 out = std::cos(angle) * DVec3(facing.x) + std::sin(angle) * DVec3(facing.y);
            o.corner[size_t(o.corners++)] = texels(view, r.end[nearer] + size * out);
        }
        return o;
    }
    const DVec3 axis = normalize(r.end[1] - r.end[0]);
    const DVec3 across = normalize(cross(axis, view.parallel ? light : middle));
    const double away = view.parallel ? std::numeric_limits<double>::infinity() : length(cross(r.end[0], axis));
    const auto add = [&](int k, double side) {
        o.corner[size_t(o.corners++)] = texels(view, r.end[k] + side * seen_radius(r.radius[k], away) * across);
    };
    add(0, -1), add(1, -1), add(1, 1), add(0, 1);
    return o;
}

double abs_sin_theta(const LightView& view, const Ribbon& ribbon, const glm::dvec2& place) {
    if (view.parallel) return std::abs(ribbon.tangent.z);
    const DVec3 light(view.low + place * view.texel, 1);
    return std::min(std::abs(dot(ribbon.tangent, light)) / length(light), 1.0);
}

}  // namespace tress
