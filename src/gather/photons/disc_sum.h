// SPDX-License-Identifier: MIT
// Irradiance as a sum over photons each of which lights a disc of its own: light is moved, but none is made or lost,
// while k photons about the point asked for count too much where it is dark and light is near.
#pragma once

#include "accel/point_balls.h"
#include "gather/photons/disc_coverage.h"
#include "gather/photons/polygon_photons.h"

namespace tress {

class DiscSum {
public:
    /// irradiance[i] at points[i]; `discs` belong to the photons. Corrected for what of a disc like those that reach
    /// the point leaves its surface.
    void operator()(const PolygonPhotons& photons, const PointBalls& discs, const KdTree& mesh_tree,
                    const TriangleMesh& mesh, Isa isa, std::span<const SurfacePoint> points, std::span<Rgb> irradiance);

private:
    DiscCoverage coverage_;
    std::vector<SurfacePoint> lit_;
    std::vector<uint32_t> row_;
    std::vector<float> radius_, share_;
};

}  // namespace tress
