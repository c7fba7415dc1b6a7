// SPDX-License-Identifier: MIT
// Photons on polygons, and the irradiance that they make about a point (Jensen 1996).
#pragma once

#include "core/path_type.h"
#include "gather/photons/photon_kernel.h"
#include "gather/photons/photon_list.h"
#include "gather/photons/surface_point.h"

namespace tress {

/// In the order of the tree.
struct PolygonPhotons {
    PointTree tree;
    std::vector<Vec3> normal;
    std::vector<Rgb> power;
    std::vector<uint8_t> type;
    RadiusBounds radius;
    size_t nearest = 0;  // that an estimate takes

    size_t size() const { return tree.size(); }
};

/// The given rows of `list`. `farthest`: coordinate of the polygons, from the scene's origin; 0: of the photons.
PolygonPhotons make_polygon_photons(const PhotonList& list, std::span<const uint32_t> rows,
                                    const PhotonOptions& options, float farthest);
size_t bytes(const PolygonPhotons& photons);

/// Photons of the same surface about a point, with the radius of the disc that they fill.
class DiscSearch {
public:
    void operator()(const PolygonPhotons& photons, const SurfacePoint& about);

    float radius() const { return radius_; }

    /// W / area of each type, as if the surface filled the disc: to be divided by the share that it covers.
    LightByType irradiance(const PolygonPhotons& photons) const;

private:
    std::vector<NearPoint> found_;
    float radius_ = 0;
};

}  // namespace tress
