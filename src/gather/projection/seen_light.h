// SPDX-License-Identifier: MIT
// Light that a point may send to the eye, direction by direction, as it would be with no hair in its way.
#pragma once

#include <vector>

#include "gather/projection/drawn_directions.h"
#include "gather/ray_buffer.h"

namespace tress {

struct SeenLight {
    Vec3 direction;
    Rgb radiance;     // that leaves the point for the eye; the sum over directions is the estimate
    float distance;   // to the polygon that it comes from; infinity: the sky
    bool among_hair;  // the polygon has hair before it, and hair behind that does not count
};

/// By a probe near the point. Replaces `to`.
void find_seen_light(const LightProbe& probe, const Igloo& igloo, const ShadingPoint& point,
                     std::span<const DrawnDirection> directions, std::vector<SeenLight>& to);

/// By rays to polygons, one a direction; the sky everywhere where there are none.
class SeenLightByRays {
public:
    void operator()(const Scene& scene, const PreparedScene& prepared, const Plan& plan, const Options& options,
                    const ShadingPoint& point, std::span<const DrawnDirection> directions, std::vector<SeenLight>& to);

private:
    RayBuffer rays_;
    std::vector<float> t_, u_, v_;
    std::vector<uint32_t> polygon_;
};

}  // namespace tress
