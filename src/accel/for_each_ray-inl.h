// SPDX-License-Identifier: MIT
// A batch of rays, one after another, and where their nearest hits go.
#if defined(TRESS_ACCEL_FOR_EACH_RAY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_ACCEL_FOR_EACH_RAY_INL_H
#undef TRESS_ACCEL_FOR_EACH_RAY_INL_H
#else
#define TRESS_ACCEL_FOR_EACH_RAY_INL_H
#endif

#include "accel/local_ray-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

/// Makes each ray ready and hands it to on_ray(i, ray); rays that cannot meet anything go to on_miss(i).
template <class OnRay, class OnMiss>
HWY_INLINE void for_each_ray(const KdTree& tree, const RayBatch& rays, const OnRay& on_ray, const OnMiss& on_miss) {
    const PaddedBounds bounds(tree.bounds);
    LocalRay ray;
    for (size_t i = 0; i < rays.size(); ++i) {
        if (!tree.empty() && make_local_ray(tree, bounds, rays, i, ray))
            on_ray(i, ray);
        else
            on_miss(i);
    }
}

HWY_INLINE void store_hit(const NearestHits& out, size_t i, float t, uint32_t id, float u, float h) {
    out.t[i] = t;
    out.id[i] = id;
    out.u[i] = u;
    out.h[i] = h;
}
HWY_INLINE void store_miss(const NearestHits& out, size_t i) { store_hit(out, i, kInfinity, kNone, 0, 0); }

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
