// SPDX-License-Identifier: MIT
// Directions that light may come from to a point: drawn by the scattering there, and by the brightness of a sky.
#pragma once

#include <vector>

#include "core/plan.h"
#include "core/sampler.h"
#include "gather/prepared_scene.h"
#include "gather/shading_point.h"

namespace tress {

struct DrawnDirection {
    Vec3 direction;
    Rgb weight;    // of a polygon's radiance: f |cos| / density; 0 where drawn by a sky
    Rgb from_sky;  // what the sky sends to the eye along it, where it is open (multiple importance sampling)
};

class DirectionDraw {
public:
    /// Replaces `to`. `directions` are drawn by the scattering, and half as many by a sky that has a picture.
    void operator()(const Scene& scene, const PreparedScene& prepared, const Plan& plan, const ShadingPoint& point,
                    const Sampler& sampler, int directions, std::vector<DrawnDirection>& to);

private:
    std::vector<glm::vec4> u_;
    std::vector<ScatteredDirection> drawn_;
};

}  // namespace tress
