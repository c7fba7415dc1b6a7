// SPDX-License-Identifier: MIT
// How photons near a point are weighed: the cone filter (Jensen 1996) over the distance to the k-th of them. Where k
// are not within the largest radius, that radius takes the k-th's place. Of photons spread evenly, sum of the weights /
// integral of the cone is their density without bias: the k-th has no weight, and the k - 1 others fill a disc in which
// (k - 1) / its area is unbiased.
#pragma once

#include <span>

#include "accel/point_tree.h"
#include "core/options.h"

namespace tress {

inline float cone(float distance2, float radius) { return glm::max(1 - std::sqrt(distance2) / radius, 0.0f); }

/// Integral of the cone over a flat disc.
inline float cone_integral(float radius) { return kPi / 3 * square(radius); }

/// Bounds of the radius of an estimate, scene units.
struct RadiusBounds {
    float least = 0;  // two photons are no nearer to each other than their roundings
    float largest = 0;
};

/// options.radius, or by the density of photons. `farthest`: coordinate of what they lie on, from the scene's origin.
RadiusBounds radius_bounds(const PointTree& photons, const PhotonOptions& options, float farthest);

/// What a photon adds an area at this distance from it: the cone. Of the least radius, where photons lie in one heap
/// and its peak would be read all over it, the mean.
inline float weight_of_disc(float distance2, float radius, const RadiusBounds& bounds) {
    if (radius > bounds.least) return cone(distance2, radius) / cone_integral(radius);
    return distance2 < square(radius) ? 1 / (kPi * square(radius)) : 0;
}

/// Largest coordinate of any of the points, without its sign.
float largest_coordinate(const PointTree& points);

/// `found`: up to k of the nearest, as find_nearest gives them.
inline float bandwidth(std::span<const NearPoint> found, size_t k, const RadiusBounds& bounds) {
    return found.size() < k ? bounds.largest : glm::max(std::sqrt(found.front().distance2), bounds.least);
}

}  // namespace tress
