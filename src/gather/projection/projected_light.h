// SPDX-License-Identifier: MIT
// Light of Type 2 by projection: hair is projected onto cells about a point, and light is seen through them.
//
// At hair, what lies beyond is read from probes that points share (light_probe.h): no rays at all. Light on polygons is
// smooth, and would show the probes: there each direction is a ray against polygons, and takes its cell's
// transmittance, unless the polygon that it meets is itself among the hair: then the hair before it is asked of the
// hair tree. From outside, where hair is small and in few directions, all rays do.
#pragma once

#include <span>
#include <vector>

#include "gather/projection/light_through_cells.h"
#include "gather/projection/probes_of_points.h"

namespace tress {

class ProjectedLight {
public:
    /// Adds to radiance[i] the light that points[i] sends to the eye.
    void operator()(const Scene& scene, const PreparedScene& prepared, const Plan& plan, const Options& options,
                    std::span<const ShadingPoint> points, std::span<const Sampler> samplers, std::span<Rgb> radiance);

private:
    void send_rays(const Bounds& hair, const ShadingPoint& point, uint32_t row, bool among_hair_only, Rgb& radiance);

    ProbesOfPoints probes_;
    DirectionDraw draw_;
    std::vector<DrawnDirection> directions_;  // of one point
    std::vector<SeenLight> seen_;             // likewise
    SeenLightByRays by_rays_;
    LightThroughCells through_cells_;

    RayBuffer rays_;  // through hair, from polygons
    std::vector<uint32_t> point_;
    std::vector<Rgb> unshadowed_, through_;
};

}  // namespace tress
