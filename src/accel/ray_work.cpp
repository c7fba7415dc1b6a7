// SPDX-License-Identifier: MIT
// Apart from queries.cpp, so that nothing here changes how the compiler makes the queries.
#include "accel/ray_work.h"

#include <algorithm>

#include "accel/highway_targets.h"
#include "accel/isa_targets.h"
#include "accel/transmission_powers.h"

#define HWY_TARGET_INCLUDE "accel/ray_work.cpp"
// foreach_target.h compiles what follows it once a target, and must stand first.
// clang-format off
#include "hwy/foreach_target.h"
#include "accel/segment_queries-inl.h"
#include "hwy/highway.h"
// clang-format on

namespace tress {
#ifndef TRESS_ACCEL_WORK_KERNELS
#define TRESS_ACCEL_WORK_KERNELS
namespace {

/// As compiled for one instruction set; they add to the work of each ray.
struct WorkKernels {
    void (*nearest)(const KdTree&, const RayBatch&, const NearestHits&, std::span<RayWork>);
    void (*transmittance)(const KdTree&, const RayBatch&, uint32_t limit, std::span<uint32_t> counts,
                          std::span<RayWork>);
};

}  // namespace
#endif
}  // namespace tress

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {
namespace {

/// A policy that does what `inner` does, and counts.
template <class Policy>
struct Counted {
    Policy& inner;
    RayWork& work;

    HWY_INLINE void step() { ++work.steps; }
    HWY_INLINE bool leaf(const KdNode& node, float t_in, float t_out) {
        ++work.leaves;
        work.tests += node.references();
        return inner.leaf(node, t_in, t_out);
    }
};

struct CountedWalk {
    std::span<RayWork> work;  // one a ray

    template <class Policy>
    HWY_INLINE void operator()(const KdTree& tree, size_t i, const LocalRay& ray, Policy& policy) const {
        Counted<Policy> counted{policy, work[i]};
        traverse(tree, ray, counted);
    }
};

void nearest_work(const KdTree& tree, const RayBatch& rays, const NearestHits& hits, std::span<RayWork> work) {
    nearest_segment_by(tree, rays, hits, CountedWalk{work});
}
void transmittance_work(const KdTree& tree, const RayBatch& rays, uint32_t limit, std::span<uint32_t> counts,
                        std::span<RayWork> work) {
    count_crossings_by(tree, rays, limit, counts, CountedWalk{work});
}

}  // namespace

WorkKernels work_kernels() { return {nearest_work, transmittance_work}; }

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tress {
namespace {

HWY_EXPORT(work_kernels);

WorkKernels kernels_for(Isa isa) { return HWY_DISPATCH_TABLE(work_kernels)[kernel_index(isa)](); }

}  // namespace

void count_nearest_work(const KdTree& tree, const RayBatch& rays, const NearestHits& hits, std::span<RayWork> work,
                        Isa isa) {
    std::fill(work.begin(), work.end(), RayWork{});
    kernels_for(isa).nearest(tree, rays, hits, work);
}

void count_transmittance_work(const KdTree& tree, const RayBatch& rays, float transmission, float cutoff,
                              std::span<uint32_t> crossings, std::span<RayWork> work, Isa isa) {
    std::fill(work.begin(), work.end(), RayWork{});
    const uint32_t limit = first_below(double(transmission), double(cutoff));
    kernels_for(isa).transmittance(tree, rays, limit, crossings, work);
}

}  // namespace tress
#endif
