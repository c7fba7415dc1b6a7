// SPDX-License-Identifier: MIT
// Rays from the points that the eye sees, drawn by their scattering: what Types 2 and 3 look along.
#pragma once

#include <span>
#include <vector>

#include "core/sampler.h"
#include "gather/shading_point.h"

namespace tress {

/// Rows belong together by index. A ray ends at the first polygon that it meets.
struct GatherRays {
    RayBuffer rays;
    std::vector<uint32_t> point;    // that it starts from
    std::vector<Sampler> samplers;  // one a ray
    std::vector<Rgb> weight;        // f |cos theta_i| / pdf / rays a point
    std::vector<float> t;           // of the polygon; infinity: none
    std::vector<uint32_t> polygon;  // triangle; kNone: none
    std::vector<float> u, v;        // where on the triangle: of corners 1 and 2

    size_t size() const { return rays.size(); }
};

/// options.gather.rays from every point; those that can bring no light are left out.
void make_gather_rays(const Scene& scene, const PreparedScene& prepared, const Options& options,
                      std::span<const ShadingPoint> points, std::span<const Sampler> samplers, GatherRays& to);

}  // namespace tress
