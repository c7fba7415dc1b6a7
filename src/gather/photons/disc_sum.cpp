// SPDX-License-Identifier: MIT
#include "gather/photons/disc_sum.h"

namespace tress {

void DiscSum::operator()(const PolygonPhotons& photons, const PointBalls& discs, const KdTree& mesh_tree,
                         const TriangleMesh& mesh, Isa isa, std::span<const SurfacePoint> points,
                         std::span<Rgb> irradiance) {
    lit_.clear();
    row_.clear();
    radius_.clear();
    for (uint32_t i = 0; i < points.size(); ++i) {
        const SurfacePoint& point = points[i];
        Rgb sum(0);
        float weights = 0, radii = 0;
        visit_holding(photons.tree, discs, point.position, [&](uint32_t place, float distance2) {
            const Vec3 chord = photons.tree.position(place) - point.position;
            if (!on_same_surface(point, chord, std::sqrt(distance2), photons.normal[place])) return;
            const float radius = discs.radius[place], weight = cone(distance2, radius) / cone_integral(radius);
            sum += weight * photons.power[place];
            weights += weight;
            radii += weight * radius;
        });
        irradiance[i] = sum;
        if (!(weights > 0)) continue;
        lit_.push_back(point);
        row_.push_back(i);
        radius_.push_back(radii / weights);
    }
    share_.resize(lit_.size());
    coverage_(mesh_tree, mesh, isa, lit_, radius_, share_);
    for (size_t l = 0; l < lit_.size(); ++l) irradiance[row_[l]] /= share_[l];
}

}  // namespace tress
