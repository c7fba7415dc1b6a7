// SPDX-License-Identifier: MIT
// The one loop that takes a ray through a tree, front to back. What a leaf does is the policy's.
#if defined(TRESS_ACCEL_TRAVERSE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_ACCEL_TRAVERSE_INL_H
#undef TRESS_ACCEL_TRAVERSE_INL_H
#else
#define TRESS_ACCEL_TRAVERSE_INL_H
#endif

#include "accel/local_ray-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

inline constexpr int kStackSize = 64;  // over the greatest depth of a tree: 60

/// Calls policy.leaf(node, t_in, t_out), true where the ray may end, for each leaf on the ray that is not empty. The
/// half-open intervals [t_in, t_out) are in order and cover [0, ray.length). Calls policy.step(), where there is one,
/// for each inner node.
template <class Policy>
HWY_INLINE void traverse(const KdTree& tree, const LocalRay& ray, Policy& policy) {
    struct Later {
        uint32_t node;
        float t_out;
    };
    Later stack[kStackSize];
    int waiting = 0;
    const KdNode* nodes = tree.nodes.data();
    KdNode node = nodes[0];
    float t_in = 0, t_out = ray.length;
    for (;;) {
        while (!node.is_leaf()) {
            if constexpr (requires { policy.step(); }) policy.step();
            const uint32_t axis = node.axis();
            const float t = (node.split() - ray.plane_origin[axis]) * ray.inverse[axis];
            const uint32_t first = node.left() + ray.from_right[axis];
            const uint32_t second = node.left() + 1 - ray.from_right[axis];
            if (t >= t_out) {
                node = nodes[first];
            } else if (!(t > t_in)) {  // also where a ray along the plane lies on it, 0 * infinity: x >= split is right
                node = nodes[second];
            } else {
                stack[waiting++] = {second, t_out};
                node = nodes[first];
                t_out = t;
            }
        }
        if (node.references() != 0 && policy.leaf(node, t_in, t_out)) return;
        if (waiting == 0) return;
        const Later next = stack[--waiting];
        node = nodes[next.node];
        t_in = t_out;
        t_out = next.t_out;
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
