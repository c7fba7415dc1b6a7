// SPDX-License-Identifier: MIT
// Paths on their way from the eye, and what all of them share.
#pragma once

#include "core/sampler.h"
#include "gather/paths/path_goals.h"
#include "gather/shading_point.h"

namespace tress {

struct PathContext {
    const Scene& scene;
    const PreparedScene& prepared;
    const Plan& plan;
    const Options& options;
    PathGoals goals;
};

struct PathWalk {
    uint32_t start;           // index of the point that the eye sees
    Sampler sampler;          // of the whole path
    uint32_t vertices = 0;    // before the last one
    ShadingPoint point;       // the last vertex
    Throughput throughput{};  // for light that leaves the last vertex along the path
    bool is_event = false;    // full model, on hair after the first vertex: scattering here is an event F or R
};

/// Numbers that a vertex of a path draws, a group of dimensions each; lights follow, in the order of the plan: lamps,
/// then environments.
enum class PathNumber : uint32_t { scattering, choices, light, count };

/// Places in the group PathNumber::choices.
inline constexpr uint32_t kFlightNumber = 0, kRouletteNumber = 1, kReservoirNumber = 2;

/// The first dimension of a group at the last vertex.
inline uint32_t dimension_of(const PathContext& context, const PathWalk& walk, PathNumber number, uint32_t light = 0) {
    const uint32_t lights = uint32_t(context.plan.lamps.size() + context.plan.environments.size());
    const uint32_t groups = uint32_t(PathNumber::count) - 1 + lights;
    return (walk.vertices * groups + uint32_t(number) + light) * kSobolGroup;
}

/// Throughput for light that arrives at the last vertex and is scattered there.
inline Throughput past_vertex(const PathWalk& walk, const Scattering& scattering) {
    return walk.is_event ? scattered(walk.throughput, scattering.forward, scattering.reflected)
                         : walk.throughput * scattering.value();
}

/// Balance heuristic (Veach 1997, eq. 9.8) for one direction drawn with density `own` that another technique draws with
/// density `other`. Densities near the largest floats do no harm.
inline float balance(float own, float other) { return 1 / (1 + other / own); }

}  // namespace tress
