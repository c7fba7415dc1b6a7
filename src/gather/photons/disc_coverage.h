// SPDX-License-Identifier: MIT
// How much of the disc about a point its surface covers: at edges, corners and creases photons are counted on less or
// more than the disc's area. Found by short rays across the tangent plane.
#pragma once

#include <span>
#include <vector>

#include "accel/kd_tree.h"
#include "core/mesh.h"
#include "core/options.h"
#include "gather/photons/surface_point.h"
#include "gather/ray_buffer.h"

namespace tress {

class DiscCoverage {
public:
    /// share[i] = integral over the surface of points[i] of the cone of radius[i] about it / that over a flat disc;
    /// above 0, about 1 on whole surfaces, above 1 on sharp creases.
    void operator()(const KdTree& tree, const TriangleMesh& mesh, Isa isa, std::span<const SurfacePoint> points,
                    std::span<const float> radius, std::span<float> share);

private:
    /// Where a ray meets the surface of its point.
    struct Probe {
        float distance = kInfinity;  // from the point; infinity: nowhere
        float cosine = 1, rise = 0;  // of the normal there to the point's; from the tangent plane
    };
    void trace(const KdTree& tree, const TriangleMesh& mesh, Isa isa, std::span<const SurfacePoint> points);
    void add(std::span<const Vec2> pattern, uint32_t point, const SurfacePoint& about, float radius);

    RayBuffer rays_, further_;
    std::vector<uint32_t> point_;  // one a ray
    std::vector<float> length_;    // likewise
    std::vector<uint32_t> ray_, further_ray_;
    std::vector<Probe> probe_;   // one a ray
    std::vector<uint32_t> cut_;  // points whose disc is not whole
    std::vector<float> t_, u_, v_;
    std::vector<uint32_t> triangle_;
};

}  // namespace tress
