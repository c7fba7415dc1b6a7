// SPDX-License-Identifier: MIT
#include "gather/photons/disc_sum.h"

namespace tress {

void DiscSum::operator()(const PolygonPhotons& photons, const PhotonDiscs& discs, const KdTree& mesh_tree,
                         const TriangleMesh& mesh, Isa isa, std::span<const SurfacePoint> points,
                         std::span<Rgb> irradiance) {
    lit_.clear();
    row_.clear();
    radius_.clear();
    sum_.clear();
    for (uint32_t i = 0; i < points.size(); ++i) {
        const SurfacePoint& point = points[i];
        Rgb sum(0), corrected(0);
        float weights = 0, radii = 0;
        visit_holding(photons.tree, discs.balls, point.position, [&](uint32_t place, float distance2) {
            const Vec3 chord = photons.tree.position(place) - point.position;
            if (!on_same_surface(point, chord, std::sqrt(distance2), photons.normal[place])) return;
            const float radius = discs.balls.radius[place], weight = weight_of_disc(distance2, radius, photons.radius);
            if (const float own = discs.own_share[place]; own > 0) {
                corrected += weight / own * photons.power[place];
                return;
            }
            sum += weight * photons.power[place];
            weights += weight;
            radii += weight * radius;
        });
        irradiance[i] = corrected;
        if (!(weights > 0)) continue;
        lit_.push_back(point);
        row_.push_back(i);
        radius_.push_back(radii / weights);
        sum_.push_back(sum);
    }
    share_.resize(lit_.size());
    coverage_(mesh_tree, mesh, isa, lit_, radius_, share_);
    for (size_t l = 0; l < lit_.size(); ++l) irradiance[row_[l]] += sum_[l] / share_[l];
}

}  // namespace tress
