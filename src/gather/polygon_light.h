// SPDX-License-Identifier: MIT
// Light of Type 2 from polygons by the method `ray`: the photon map where gather rays end, seen through the hair.
#pragma once

#include "gather/gather_rays.h"
#include "gather/visibility.h"

namespace tress {

/// Radiance that a triangle of the scene sends back along a ray in `direction` that meets it at `at`.
Rgb polygon_radiance(const Scene& scene, const IrradianceMap& map, uint32_t triangle, const Vec3& at,
                     const Vec3& direction);

class PolygonLight {
public:
    /// Adds to radiance[i] the light that points[i], where the rays start, sends to the eye.
    void operator()(const Scene& scene, const PreparedScene& prepared, const Options& options, const GatherRays& rays,
                    std::span<Rgb> radiance);

private:
    RayBuffer lit_rays_;  // those that end on a lit polygon
    std::vector<uint32_t> point_;
    std::vector<Rgb> unshadowed_, visibility_;
};

}  // namespace tress
