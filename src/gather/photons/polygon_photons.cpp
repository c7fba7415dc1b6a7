// SPDX-License-Identifier: MIT
#include "gather/photons/polygon_photons.h"

namespace tress {

PolygonPhotons make_polygon_photons(const PhotonList& list, std::span<const uint32_t> rows,
                                    const PhotonOptions& options, float farthest) {
    std::vector<Vec3> position;
    position.reserve(rows.size());
    for (const uint32_t row : rows) position.push_back(list.position(row));
    PolygonPhotons photons;
    photons.tree = make_point_tree(position);
    photons.normal.reserve(rows.size());
    photons.power.reserve(rows.size());
    photons.type.reserve(rows.size());
    for (const uint32_t id : photons.tree.id) {
        photons.normal.push_back(list.normal[rows[id]]);
        photons.power.push_back(list.power[rows[id]]);
        photons.type.push_back(list.type[rows[id]]);
    }
    photons.radius = radius_bounds(photons.tree, options, farthest);
    photons.nearest = size_t(options.nearest);
    return photons;
}

size_t bytes(const PolygonPhotons& photons) {
    return bytes(photons.tree) + photons.normal.capacity() * sizeof(Vec3) + photons.power.capacity() * sizeof(Rgb) +
           photons.type.capacity();
}

void DiscSearch::operator()(const PolygonPhotons& photons, const SurfacePoint& about) {
    const auto counts = [&](uint32_t place, float distance2) {
        return on_same_surface(about, photons.tree.position(place) - about.position, std::sqrt(distance2),
                               photons.normal[place]);
    };
    find_nearest(photons.tree, about.position, photons.nearest, photons.radius.largest, counts, found_);
    radius_ = bandwidth(found_, photons.nearest, photons.radius);
}

LightByType DiscSearch::irradiance(const PolygonPhotons& photons) const {
    LightByType sum{};
    for (const NearPoint& near : found_)
        sum[photons.type[near.place]] +=
            weight_of_disc(near.distance2, radius_, photons.radius) * photons.power[near.place];
    return sum;
}

}  // namespace tress
