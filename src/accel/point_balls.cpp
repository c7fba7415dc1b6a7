// SPDX-License-Identifier: MIT
#include "accel/point_balls.h"

namespace tress {
namespace {

float fill_largest(PointBalls& balls, uint32_t begin, uint32_t end) {
    if (begin == end) return 0;
    const uint32_t middle = begin + (end - begin) / 2;
    float largest = balls.radius[middle];
    if (end - begin > PointTree::kLeafPoints) {
        largest = glm::max(largest, fill_largest(balls, begin, middle));
        largest = glm::max(largest, fill_largest(balls, middle + 1, end));
    } else {
        for (uint32_t place = begin; place < end; ++place) largest = glm::max(largest, balls.radius[place]);
    }
    return balls.largest[middle] = largest;
}

}  // namespace

PointBalls make_point_balls(const PointTree& centers, std::vector<float> radius) {
    PointBalls balls{std::move(radius), std::vector<float>(centers.size())};
    fill_largest(balls, 0, uint32_t(centers.size()));
    return balls;
}

}  // namespace tress
