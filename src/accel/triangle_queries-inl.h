// SPDX-License-Identifier: MIT
// Queries on triangles: a short policy each for the loop of traverse-inl.h.
#if defined(TRESS_ACCEL_TRIANGLE_QUERIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_ACCEL_TRIANGLE_QUERIES_INL_H
#undef TRESS_ACCEL_TRIANGLE_QUERIES_INL_H
#else
#define TRESS_ACCEL_TRIANGLE_QUERIES_INL_H
#endif

#include "accel/for_each_ray-inl.h"
#include "accel/traverse-inl.h"
#include "accel/triangle_test-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

/// A triangle on a split plane may be stored on either side: hits count wherever on the ray they lie.
struct NearestTriangle {
    const KdTree& tree;
    const LocalRay& ray;
    Shear shear{ray};
    float t = ray.length;
    uint32_t id = kNone;
    float u = 0, v = 0;

    HWY_INLINE bool leaf(const KdNode& node, float, float t_out) {
        const auto on_hits = [this](const float* block, size_t lane, const TriangleHits& hits) {
            const FloatTag d;
            uint32_t bits =
                bits_of(hn::And(hits.met, hn::And(hn::Ge(hits.t, hn::Zero(d)), hn::Le(hits.t, hn::Set(d, t)))));
            if (bits == 0) return false;
            HWY_ALIGN float at_t[kLanes], at_u[kLanes], at_v[kLanes];
            hn::Store(hits.t, d, at_t);
            hn::Store(hits.u, d, at_u);
            hn::Store(hits.v, d, at_v);
            for (; bits != 0; bits &= bits - 1) {
                const uint32_t k = uint32_t(std::countr_zero(bits));
                const uint32_t other = std::bit_cast<uint32_t>(block[triangle_row::id * kLanes + lane + k]);
                const bool nearer = at_t[k] < t || (at_t[k] == t && id != kNone && other < id);
                if (!nearer) continue;
                t = at_t[k];
                id = other;
                u = at_u[k];
                v = at_v[k];
            }
            return false;
        };
        meet_triangles(tree, ray, shear, node, on_hits);
        return t < t_out;
    }
};

struct AnyTriangle {
    const KdTree& tree;
    const LocalRay& ray;
    Shear shear{ray};
    bool met = false;

    HWY_INLINE bool leaf(const KdNode& node, float, float) {
        const auto on_hits = [this](const float*, size_t, const TriangleHits& hits) {
            const FloatTag d;
            const Lanes within = hn::And(hn::Ge(hits.t, hn::Zero(d)), hn::Lt(hits.t, hn::Set(d, ray.length)));
            return !hn::AllFalse(d, hn::And(hits.met, within));
        };
        met = meet_triangles(tree, ray, shear, node, on_hits);
        return met;
    }
};

void nearest_triangle(const KdTree& tree, const RayBatch& rays, const NearestHits& out) {
    const auto trace = [&](size_t i, const LocalRay& ray) {
        NearestTriangle nearest{tree, ray};
        traverse(tree, ray, nearest);
        if (nearest.id == kNone) return store_miss(out, i);
        store_hit(out, i, ray.caller_t(nearest.t), nearest.id, nearest.u, nearest.v);
    };
    for_each_ray(tree, rays, trace, [&](size_t i) { store_miss(out, i); });
}

void occluded_triangle(const KdTree& tree, const RayBatch& rays, std::span<uint8_t> occluded) {
    const auto trace = [&](size_t i, const LocalRay& ray) {
        AnyTriangle any{tree, ray};
        traverse(tree, ray, any);
        occluded[i] = any.met;
    };
    for_each_ray(tree, rays, trace, [&](size_t i) { occluded[i] = 0; });
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
