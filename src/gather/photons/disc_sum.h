// SPDX-License-Identifier: MIT
// Irradiance as a sum over photons each of which lights a disc of its own: light is moved, but none is made or lost,
// while k photons about the point asked for count too much where it is dark and light is near.
#pragma once

#include "accel/point_balls.h"
#include "gather/photons/disc_coverage.h"
#include "gather/photons/polygon_photons.h"

namespace tress {

/// Discs of photons, in the order of their tree. What of a disc leaves its surface is corrected for at the points that
/// it lights, by discs like those that reach them: of even light that leaves no error. Where photons are so few that a
/// disc is of the largest radius, surfaces may be smaller than discs, and that would make light: such a disc is
/// corrected by its own share, once for all.
struct PhotonDiscs {
    PointBalls balls;
    std::vector<float> own_share;  // of the disc that its surface covers; 0: corrected at points
};

class DiscSum {
public:
    /// irradiance[i] at points[i].
    void operator()(const PolygonPhotons& photons, const PhotonDiscs& discs, const KdTree& mesh_tree,
                    const TriangleMesh& mesh, Isa isa, std::span<const SurfacePoint> points, std::span<Rgb> irradiance);

private:
    DiscCoverage coverage_;
    std::vector<SurfacePoint> lit_;
    std::vector<uint32_t> row_;
    std::vector<float> radius_, share_;
    std::vector<Rgb> sum_;  // to be corrected at the point
};

}  // namespace tress
