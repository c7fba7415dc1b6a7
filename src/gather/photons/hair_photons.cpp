// SPDX-License-Identifier: MIT
#include "gather/photons/hair_photons.h"

#include "core/hair_points.h"

namespace tress {
namespace {

// Points on the hair a photon: 200 within the ball of 50 photons, where photons are as dense as on average.
constexpr size_t kPointsAPhoton = 4, kFewestPoints = 1 << 16, kMostPoints = 1 << 24;

// A photon that meets its fiber along the axis would speak for infinitely many. One in 10,000 of even light is below.
constexpr float kLeastCosine = 0.01f;

/// Integral over the hair about a point of the cone of `radius`.
float cone_over_hair(const HairPhotons& photons, const Vec3& about, float radius) {
    constexpr float kMeanCone = 0.25f;  // over a ball
    float sum = 0, count = 0;
    const float radius2 = square(radius);
    visit_near(photons.area_points, about, radius2, [&](uint32_t, float distance2) {
        sum += cone(distance2, radius);
        ++count;
        return radius2;
    });
    // The mean of 1 / (n + 1) over a Poisson number n is 1 / its mean, but for what exp(-mean) leaves.
    return photons.area * (count > 0 ? sum * (1 + 1 / count) : kMeanCone);
}

}  // namespace

HairPhotons make_hair_photons(const PhotonList& list, std::span<const uint32_t> rows, const SegmentView& segments,
                              const PhotonOptions& options) {
    HairPhotons photons;
    if (rows.empty()) return photons;
    std::vector<Vec3> position;
    position.reserve(rows.size());
    for (const uint32_t row : rows) position.push_back(list.position(row));
    photons.tree = make_point_tree(position);
    photons.direction.reserve(rows.size());
    photons.power.reserve(rows.size());
    photons.type.reserve(rows.size());
    for (const uint32_t id : photons.tree.id) {
        photons.direction.push_back(list.direction[rows[id]]);
        photons.power.push_back(list.power[rows[id]] / glm::max(list.cosine[rows[id]], kLeastCosine));
        photons.type.push_back(list.type[rows[id]]);
    }
    const HairPoints points =
        spread_points(segments, glm::clamp(kPointsAPhoton * rows.size(), kFewestPoints, kMostPoints));
    photons.area_points = make_point_tree(points.position);
    photons.area = points.area;
    photons.radius = radius_bounds(photons.tree, options, largest_coordinate(photons.area_points));
    photons.nearest = size_t(options.nearest);
    return photons;
}

size_t bytes(const HairPhotons& photons) {
    return bytes(photons.tree) + bytes(photons.area_points) + photons.direction.capacity() * sizeof(Vec3) +
           photons.power.capacity() * sizeof(Rgb) + photons.type.capacity();
}

void HairSearch::operator()(const HairPhotons& photons, const Vec3& about) {
    beams_.clear();
    find_nearest(
        photons.tree, about, photons.nearest, photons.radius.largest, [](uint32_t, float) { return true; }, near_);
    if (near_.empty()) return;
    const float radius = bandwidth(near_, photons.nearest, photons.radius);
    const float per_area = 1 / cone_over_hair(photons, about, radius);
    for (const NearPoint& near : near_) {
        const float weight = cone(near.distance2, radius) * per_area;
        if (weight > 0) beams_.push_back({near.place, weight * photons.power[near.place]});
    }
}

}  // namespace tress
