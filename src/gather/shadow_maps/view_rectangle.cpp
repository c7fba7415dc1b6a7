// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/view_rectangle.h"

namespace tress {
namespace {

/// Between the tangents from the origin to a circle about (x, z), as x / z on them. The circle lies at z > 0.
struct Interval {
    double low, high;
};
Interval tangents(double x, double z, double radius) {
    const double middle = x * z, below = (z - radius) * (z + radius);
    const double spread = radius * std::sqrt(x * x + below);
    return {(middle - spread) / below, (middle + spread) / below};
}

ViewRectangle rectangle_of_ball(const DVec3& center, double radius, Projection projection) {
    if (projection == Projection::parallel) return {glm::dvec2(center) - radius, glm::dvec2(center) + radius};
    if (!(center.z > radius)) return kEverywhere;
    const Interval x = tangents(center.x, center.z, radius), y = tangents(center.y, center.z, radius);
    return {{x.low, y.low}, {x.high, y.high}};
}

/// Part of a line, as parameters: 0 at its start, 1 at its end.
struct Part {
    double from = 0, to = 1;

    /// Keeps where a linear function, `at_start` and `at_end` there, is at most `limit`.
    void keep_below(double limit, double at_start, double at_end) {
        if (at_start <= limit && at_end <= limit) return;
        const double crossing = (limit - at_start) / (at_end - at_start);
        if (at_start > limit) from = at_end > limit ? kInfinity : glm::max(from, crossing);
        if (at_end > limit) to = glm::min(to, crossing);
    }
};

}  // namespace

ViewRectangle rectangle_of(const ViewHair& hair, Projection projection) {
    ViewRectangle r = rectangle_of_ball(hair.end[0], hair.radius[0], projection);
    r.add(rectangle_of_ball(hair.end[1], hair.radius[1], projection));
    return r;
}

/// sqrt(x^2 + z^2 - r^2) of the tangents is at most |x| + z.
ViewRectangle rectangle_about_ball(const DVec3& center, double radius, Projection projection) {
    if (projection == Projection::parallel) return {glm::dvec2(center) - radius, glm::dvec2(center) + radius};
    if (!(center.z > radius)) return kEverywhere;
    const double scale = 1 / ((center.z - radius) * (center.z + radius));
    const glm::dvec2 middle = glm::dvec2(center) * center.z, spread = radius * (abs(glm::dvec2(center)) + center.z);
    return {(middle - spread) * scale, (middle + spread) * scale};
}

std::optional<ViewHair> clip(const ViewHair& hair, const ViewRectangle& rectangle, Projection projection) {
    const bool pinhole = projection == Projection::pinhole;
    const double radius = glm::max(hair.radius[0], hair.radius[1]);
    const DVec3 &a = hair.end[0], &b = hair.end[1];
    Part part;
    if (pinhole) part.keep_below(radius, -a.z, -b.z);
    for (int axis = 0; axis < 2; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            const double side = sign < 0 ? rectangle.low[axis] : rectangle.high[axis];
            if (std::isinf(side)) continue;
            if (pinhole)
                part.keep_below(radius * std::sqrt(1 + side * side), sign * (a[axis] - side * a.z),
                                sign * (b[axis] - side * b.z));
            else
                part.keep_below(radius, sign * (a[axis] - side), sign * (b[axis] - side));
        }
    }
    if (!(part.from <= part.to)) return std::nullopt;
    return ViewHair{
        {glm::mix(a, b, part.from), glm::mix(a, b, part.to)},
        {glm::mix(hair.radius[0], hair.radius[1], part.from), glm::mix(hair.radius[0], hair.radius[1], part.to)}};
}

}  // namespace tress
