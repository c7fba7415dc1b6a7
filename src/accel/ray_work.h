// SPDX-License-Identifier: MIT
// What a query does for a ray, counted: the same answers, found in the same way as by the queries of queries.h, with
// the same early ends. Counts do not depend on the instruction set, nor on how rays are divided into batches.
#pragma once

#include <cstdint>
#include <span>

#include "accel/queries.h"

namespace tress {

/// All 0: the ray passes the tree's bounds.
struct RayWork {
    uint64_t steps = 0;   // inner nodes that it steps through
    uint64_t leaves = 0;  // that it visits; empty ones, which ask nothing, are not counted
    uint64_t tests = 0;   // references of these leaves, those after an early end inside the last one too; no padding

    bool operator==(const RayWork&) const = default;
    RayWork& operator+=(const RayWork& other) {
        steps += other.steps;
        leaves += other.leaves;
        tests += other.tests;
        return *this;
    }
};

/// As nearest_segment, and as transmittance_constant without the products. `work`: one a ray.
void count_nearest_work(const KdTree& tree, const RayBatch& rays, const NearestHits& hits, std::span<RayWork> work,
                        Isa isa);
void count_transmittance_work(const KdTree& tree, const RayBatch& rays, float transmission, float cutoff,
                              std::span<uint32_t> crossings, std::span<RayWork> work, Isa isa);

}  // namespace tress
