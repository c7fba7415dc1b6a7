// SPDX-License-Identifier: MIT
// What a place sees of everything but hair, found by rays.
#pragma once

#include "core/plan.h"
#include "gather/prepared_scene.h"
#include "gather/ray_buffer.h"

namespace tress {

/// The igloo is turned, and the ray of each cell drawn, by `key`. `excluded` as for rays that start at `position`.
LightProbe make_light_probe(const Scene& scene, const PreparedScene& prepared, const Plan& plan, const Igloo& igloo,
                            const Vec3& position, const Excluded& excluded, uint64_t key, Isa isa);

}  // namespace tress
