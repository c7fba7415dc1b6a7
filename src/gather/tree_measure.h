// SPDX-License-Identifier: MIT
// One tree of hair, measured: how long its build takes, what it is like, and how fast rays pass it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "accel/statistics.h"
#include "accel/tree_limits.h"
#include "gather/tree_rays.h"

namespace tress {

/// How fast one set of rays is answered, and what that takes.
struct RayRate {
    std::string rays;             // name of the set
    std::string query;            // "nearest" for primary rays, "transmittance" for others
    uint64_t traced = 0;          // while the clock ran; in whole passes over the set a ray is traced more than once
    double seconds = 0;           // that the clock ran
    double mrays_per_second = 0;  // of all threads together: the median of whole passes, or of what one pass got to
    uint64_t counted = 0;         // rays whose work was counted
    double steps = 0, leaves = 0, tests = 0;  // a ray, of these: see accel/ray_work.h
};

struct TreeMeasure {
    double build_seconds = 0;
    TreeStatistics statistics;
    std::vector<RayRate> rates;  // one a set that is not empty
};

/// What a crossing lets through, and the transmittance below which a ray ends, in "transmittance": as `tress trace`.
inline constexpr float kMeasuredTransmission = 0.7f, kMeasuredCutoff = 1e-3f;

/// Of the trees that are measured: what is larger is refused.
inline constexpr TreeLimits kMeasuredLimits{.bytes = 8ull << 30};

/// Builds the tree (InputError: it would pass a limit) and traces each set for about `seconds`, whatever the tree: half
/// to one and a half times, and 0.35 times for warming up and counting. Batches are asked in an order of which every
/// beginning is spread evenly over the picture; the last one is left where time is up. By as many threads as TBB has
/// here; options.isa is used. Counts are of the same rays for every tree, unless time is up.
TreeMeasure measure_tree(const SegmentView& segments, const AccelOptions& accel, std::span<const TreeRays> rays,
                         const Options& options, double seconds, const TreeLimits& limits = kMeasuredLimits);

/// The sets alone, on a tree that is there.
RayRate measure_rays(const KdTree& tree, const TreeRays& rays, Isa isa, double seconds);

}  // namespace tress
