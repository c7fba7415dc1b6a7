// SPDX-License-Identifier: MIT
// Which probe a point sees by.
#pragma once

#include <deque>
#include <span>
#include <vector>

#include "core/sampler.h"
#include "gather/prepared_scene.h"
#include "gather/projection/projection_scratch.h"
#include "gather/shading_point.h"

namespace tress {

/// Drawn among the corners of the point's cube by their weights, so that over many points probes are interpolated; one
/// that a polygon hides is passed over. A point that sees none gets its own.
class ProbesOfPoints {
public:
    /// Of those at hair.
    void find(const Scene& scene, const PreparedScene& prepared, const Plan& plan, const Options& options,
              std::span<const ShadingPoint> points, std::span<const Sampler> samplers);
    const LightProbe& of(size_t point) const { return *probe_[point]; }

private:
    LightProbe make_at_corner(const Scene& scene, const PreparedScene& prepared, const Plan& plan,
                              const Options& options, const ProbeCube& cube, int corner);

    struct Search {
        uint32_t point;
        ProbeCube cube;
        int corner;
        uint32_t passed_over;  // one bit a corner
        uint64_t key;          // of the point
    };

    std::vector<const LightProbe*> probe_;
    std::deque<LightProbe> own_;
    std::vector<Search> searches_, tried_;
    RayBuffer rays_;
    std::vector<uint8_t> occluded_;

    ProjectionScratch scratch_;  // for far hair
    std::vector<float> sight_;
};

}  // namespace tress
