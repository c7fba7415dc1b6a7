// SPDX-License-Identifier: MIT
// Rectangles that hair fills in a view, exactly: the shadow of a ball in a pinhole is a cone's cut, and that of a fiber
// with round ends is the convex hull of its ends' shadows.
#pragma once

#include <optional>

#include "core/math.h"

namespace tress {

enum class Projection { pinhole, parallel };

/// In the plane z = 1 of a pinhole (x / z, y / z), or in x and y of a parallel view. Empty until something is added.
struct ViewRectangle {
    glm::dvec2 low{std::numeric_limits<double>::infinity()};
    glm::dvec2 high{-std::numeric_limits<double>::infinity()};

    bool empty() const { return !(low.x <= high.x && low.y <= high.y); }
    glm::dvec2 extent() const { return high - low; }
    bool contains(const ViewRectangle& other) const {
        return glm::all(glm::lessThanEqual(low, other.low)) && glm::all(glm::lessThanEqual(other.high, high));
    }
    bool meets(const ViewRectangle& other) const {
        return glm::all(glm::lessThanEqual(low, other.high)) && glm::all(glm::lessThanEqual(other.low, high));
    }
    void add(const ViewRectangle& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
};

inline constexpr ViewRectangle kEverywhere{glm::dvec2(-std::numeric_limits<double>::infinity()),
                                           glm::dvec2(std::numeric_limits<double>::infinity())};

/// What both hold: may be empty.
inline ViewRectangle cut(const ViewRectangle& a, const ViewRectangle& b) {
    return {glm::max(a.low, b.low), glm::min(a.high, b.high)};
}

/// `by` on all sides.
inline ViewRectangle grown(const ViewRectangle& r, double by) { return {r.low - by, r.high + by}; }

/// A piece of fiber with round ends, in a view's frame: from the view's origin, z along the light.
struct ViewHair {
    DVec3 end[2];
    double radius[2];

    /// Smallest z of it.
    double nearest() const { return glm::min(end[0].z - radius[0], end[1].z - radius[1]); }
};

/// The smallest rectangle about it; infinite where it reaches the plane z = 0 of a pinhole.
ViewRectangle rectangle_of(const ViewHair& hair, Projection projection);

/// A rectangle that holds that of a ball, found without a root; infinite likewise.
ViewRectangle rectangle_about_ball(const DVec3& center, double radius, Projection projection);

/// What of it may fall within a rectangle: its axis cut with the rectangle's pyramid (or beam) grown by the radius, so
/// that nothing is left out.
std::optional<ViewHair> clip(const ViewHair& hair, const ViewRectangle& rectangle, Projection projection);

}  // namespace tress
