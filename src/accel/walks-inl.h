// SPDX-License-Identifier: MIT
// Ways for a query to have its rays traversed: plainly, or with the work of each ray counted.
#if defined(TRESS_ACCEL_WALKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_ACCEL_WALKS_INL_H
#undef TRESS_ACCEL_WALKS_INL_H
#else
#define TRESS_ACCEL_WALKS_INL_H
#endif

#include "accel/ray_work.h"
#include "accel/traverse-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

struct PlainWalk {
    template <class Policy>
    HWY_INLINE void operator()(const KdTree& tree, size_t, const LocalRay& ray, Policy& policy) const {
        traverse(tree, ray, policy);
    }
};

/// Does what `inner` does, and counts.
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
    std::span<RayWork> work;  // one a ray; cleared before

    template <class Policy>
    HWY_INLINE void operator()(const KdTree& tree, size_t i, const LocalRay& ray, Policy& policy) const {
        Counted<Policy> counted{policy, work[i]};
        traverse(tree, ray, counted);
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
