// SPDX-License-Identifier: MIT
// What a path may still bring: it is followed no further than a type that is wanted asks.
#pragma once

#include "core/plan.h"
#include "gather/paths/throughput.h"

namespace tress {

struct PathGoals {
    TypeSet wanted{};
    bool areas = false;        // lamps that a ray may pass through
    bool sky = false;          // environments
    bool polygons = false;     // rays may end on one
    bool reflections = false;  // rays may end in an event R at a fiber
    bool forward = false;      // and in an event F (full model)
};

PathGoals path_goals(const Scene& scene, const Plan& plan, const Options& options);

/// Whether light from `source` is wanted that enters here.
bool takes(const PathGoals& goals, const Throughput& throughput, LightSource source);

/// Whether a ray that goes on from here may meet light that is wanted.
bool goes_on(const PathGoals& goals, const Throughput& throughput);

/// Without the states that no wanted type can come of, here or further on.
Throughput still_wanted(const PathGoals& goals, Throughput throughput);

/// Adds `radiance` from `source` to the wanted types.
void book(const PathGoals& goals, const Throughput& throughput, LightSource source, const Rgb& radiance,
          LightByType& light);

}  // namespace tress
