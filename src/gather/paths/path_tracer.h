// SPDX-License-Identifier: MIT
// The reference: unidirectional path tracing with next-event estimation and multiple importance sampling; each
// contribution is booked to the type of its path. No photons, no limit of depth but roulette.
//
// Roulette ends a path with the chance that its throughput has fallen by, and counts survivors so much more. That
// leaves the mean as it is and adds noise: light of many events comes as few bright samples. Nothing is clamped, so
// fireflies stay in the picture and in its variance.
#pragma once

#include <span>
#include <vector>

#include "gather/paths/path_lights.h"
#include "gather/paths/path_rays.h"
#include "gather/paths/path_walk.h"

namespace tress {

class PathTracer {
public:
    /// Adds to light[i], for the types in plan.paths, one sample of what points[i] sends to the eye.
    void operator()(const Scene& scene, const PreparedScene& prepared, const Plan& plan, const Options& options,
                    std::span<const ShadingPoint> points, std::span<const Sampler> samplers,
                    std::span<LightByType> light);

private:
    /// A ray that leaves a walk's last vertex.
    struct Departure {
        uint32_t walk;
        float pdf;              // of its direction by scattering
        Throughput throughput;  // of light that comes along it
    };

    void depart(const PathContext& context);
    void book_lights(const PathContext& context, std::span<LightByType> light) const;
    void arrive(const PathContext& context);

    std::vector<PathWalk> walks_, next_;
    std::vector<Departure> departures_;  // rays_ has one each
    std::vector<float> chances_;
    PathLights lights_;
    PathRays rays_;
};

}  // namespace tress
