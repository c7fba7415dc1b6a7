// SPDX-License-Identifier: MIT
// Questions to a kd-tree, asked for batches of rays: arrays in, arrays out. A ray is origin + t direction for
// t in [t_near, t_far); directions need not be unit; t is in units of the direction's length. Answers do not depend on
// the instruction set, nor on the number of threads (queries run on the calling thread).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "accel/isa_targets.h"
#include "accel/kd_tree.h"
#include "core/attenuation.h"
#include "core/options.h"

namespace tress {

/// Rays as arrays. Segments of [skip_first, skip_last] are not met by that ray; absent (empty): nothing is skipped.
struct RayBatch {
    std::span<const float> ox, oy, oz, dx, dy, dz, t_near, t_far;
    std::span<const uint32_t> skip_first, skip_last;

    size_t size() const { return ox.size(); }
    /// Rays [first, first + count).
    RayBatch part(size_t first, size_t count) const {
        const auto of = [&](const auto& values) { return values.empty() ? values : values.subspan(first, count); };
        return {of(ox), of(oy), of(oz), of(dx), of(dy), of(dz), of(t_near), of(t_far), of(skip_first), of(skip_last)};
    }
};

/// Nearest hit of each ray: t = infinity and id = kNone where there is none. Of hits at the same t, the smaller id.
/// Segments: u along the axis in [0, 1], h = signed offset / radius, along normalize(cross(direction, axis)).
/// Triangles: u, v are the barycentric coordinates of corners 1 and 2; h holds v.
struct NearestHits {
    std::span<float> t;
    std::span<uint32_t> id;
    std::span<float> u, h;
};
void nearest_segment(const KdTree& tree, const RayBatch& rays, const NearestHits& hits, Isa isa);
void nearest_triangle(const KdTree& tree, const RayBatch& rays, const NearestHits& hits, Isa isa);

/// Whether anything is met in [t_near, t_far): 1 or 0.
void occluded_triangle(const KdTree& tree, const RayBatch& rays, std::span<uint8_t> occluded, Isa isa);

/// Product of one transmission over all crossings, and their number, stopped at the first k with
/// transmission^k < cutoff.
void transmittance_constant(const KdTree& tree, const RayBatch& rays, float transmission, float cutoff,
                            std::span<float> transmittance, std::span<uint32_t> crossings, Isa isa);

/// exp of minus the summed optical depth of all crossings, a colour; stopped where every channel is below cutoff.
void transmittance(const KdTree& tree, const RayBatch& rays, const Attenuation& attenuation, float cutoff,
                   std::span<Rgb> transmittance, Isa isa);

/// All crossings of each ray in the order of t (ties: the smaller id): ray i owns first[i] .. first[i + 1] - 1.
struct Crossings {
    std::vector<uint64_t> first;
    std::vector<float> t, u, h;
    std::vector<uint32_t> id;
};
Crossings crossings(const KdTree& tree, const RayBatch& rays, Isa isa);

/// The first crossings of each ray, in order, up to and with the one that takes its transmittance below its cutoff in
/// every channel (`cutoff`: one a ray; 0: all of them).
struct Flights {
    Crossings crossings;
    std::vector<Rgb> before, after;  // transmittance up to each crossing, without and with it
};
void flights(const KdTree& tree, const RayBatch& rays, const Attenuation& attenuation, std::span<const float> cutoff,
             Flights& found, Isa isa);

}  // namespace tress
