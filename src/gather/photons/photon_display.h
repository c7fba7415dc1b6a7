// SPDX-License-Identifier: MIT
// Light of Types 4 and 5 by the method `photons`: those stored in the hair and on polygons, shown directly (Moon &
// Marschner 2006; Zinke & Weber 2006).
#pragma once

#include <span>
#include <vector>

#include "core/path_type.h"
#include "gather/photons/disc_coverage.h"
#include "gather/shading_point.h"

namespace tress {

class PhotonDisplay {
public:
    /// Adds to light[i], what points[i] sends to the eye.
    void operator()(const Scene& scene, const PreparedScene& prepared, const Options& options,
                    std::span<const ShadingPoint> points, std::span<LightByType> light);

private:
    void show_on_fiber(const Scene& scene, const HairPhotons& photons, const ShadingPoint& point, LightByType& light);
    void show_on_polygons(const Scene& scene, const PreparedScene& prepared, const Options& options,
                          std::span<const ShadingPoint> points, std::span<LightByType> light);

    HairSearch hair_;
    DiscSearch disc_;
    DiscCoverage coverage_;
    std::vector<Vec3> wi_;
    std::vector<FiberScattering> scattered_;
    std::vector<uint32_t> on_polygon_;
    std::vector<SurfacePoint> surface_;
    std::vector<LightByType> irradiance_;
    std::vector<float> radius_, share_;
};

}  // namespace tress
