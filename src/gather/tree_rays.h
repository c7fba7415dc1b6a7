// SPDX-License-Identifier: MIT
// The rays that a render asks of the tree of hair, in sets by what they are for: what a tree is measured on.
#pragma once

#include <string>
#include <vector>

#include "core/plan.h"
#include "gather/prepared_scene.h"
#include "gather/ray_buffer.h"

namespace tress {

/// Which query of accel/queries.h rays are asked.
enum class HairQuery { nearest, transmittance };

struct TreeRays {
    std::string name;  // "primary", "shadow", "gather"
    HairQuery query;
    RayBuffer rays;  // tile after tile, as the renderer asks them
};

/// What make_tree_rays needs of a scene, whatever types of light are on: trees, and the lamps that shine into the
/// picture; where there is none, the environments.
Plan plan_tree_rays(const Scene& scene);

/// Three sets, of at most `most` rays each, the same whatever the number of threads (another tree moves the points of
/// hair by rounding):
///   primary: from the camera, through tiles spread evenly over the picture, or through all of it more than once
///   shadow: from points of hair that those tiles see towards each light of the plan, up to it
///   gather: from the same points, drawn by their scattering, up to the first polygon
/// As in a render, rays from hair skip their own strand nearby, ways that bring no light or that polygons block are
/// left out, and shadow rays are drawn as direct light draws them. `plan`, `prepared`: of plan_tree_rays, or more.
/// `options`: seed, filter and instruction set are used.
std::vector<TreeRays> make_tree_rays(const Scene& scene, const Plan& plan, const PreparedScene& prepared,
                                     const Options& options, size_t most = 100'000);

}  // namespace tress
