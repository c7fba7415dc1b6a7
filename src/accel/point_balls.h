// SPDX-License-Identifier: MIT
// Balls about the points of a tree: which of them hold a point.
#pragma once

#include "accel/point_tree.h"

namespace tress {

/// In the order of the tree of their centres.
struct PointBalls {
    std::vector<float> radius;
    std::vector<float> largest;  // at the middle of a range of the tree: in that range
};

PointBalls make_point_balls(const PointTree& centers, std::vector<float> radius);

/// Calls visit(place, distance2) for the balls that hold `p`, in a fixed order.
template <class Visit>
void visit_holding(const PointTree& centers, const PointBalls& balls, const Vec3& p, const Visit& visit) {
    const auto offer = [&](uint32_t place) {
        const float distance2 = centers.distance2(p, place);
        if (distance2 < square(balls.radius[place])) visit(place, distance2);
    };
    traverse(centers, p, offer, [&](const PlaceRange& range) {
        return range.begin < range.end && range.distance2 < square(balls.largest[range.middle()]);
    });
}

}  // namespace tress
