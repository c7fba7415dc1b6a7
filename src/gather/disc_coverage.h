// SPDX-License-Identifier: MIT
// How much of the disc about a point its surface covers: at edges, corners and creases photons are counted on less or
// more than the disc's area. Found by short rays across the tangent plane.
#pragma once

#include <span>
#include <vector>

#include "accel/kd_tree.h"
#include "core/mesh.h"
#include "core/options.h"
#include "gather/ray_buffer.h"
#include "gather/surface_point.h"

namespace tress {

class DiscCoverage {
public:
    /// share[i] = integral over the surface of points[i] of the cone of radius[i] about it / that over a flat disc;
    /// above 0, about 1 on whole surfaces, above 1 on sharp creases. Of hits that are no part of the surface only the
    /// first is seen through: none.
    void operator()(const KdTree& tree, const TriangleMesh& mesh, Isa isa, std::span<const SurfacePoint> points,
                    std::span<const float> radius, std::span<float> share);

private:
    struct Probe {
        Vec3 chord, normal;
        float distance;
        bool on_surface;
    };
    void trace(const KdTree& tree, Isa isa);
    Probe probe(size_t ray, const TriangleMesh& mesh, const SurfacePoint& point) const;

    RayBuffer rays_;
    std::vector<uint32_t> cut_;  // points whose disc is not whole
    std::vector<float> t_, u_, v_;
    std::vector<uint32_t> triangle_;
};

}  // namespace tress
