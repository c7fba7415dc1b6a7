// SPDX-License-Identifier: MIT
// Queries on segments: a short policy each for the loop of traverse-inl.h.
#if defined(TRESS_ACCEL_SEGMENT_QUERIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_ACCEL_SEGMENT_QUERIES_INL_H
#undef TRESS_ACCEL_SEGMENT_QUERIES_INL_H
#else
#define TRESS_ACCEL_SEGMENT_QUERIES_INL_H
#endif

#include <algorithm>

#include "accel/crossing_owner-inl.h"
#include "accel/for_each_ray-inl.h"
#include "accel/segment_test-inl.h"
#include "accel/traverse-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

HWY_INLINE uint32_t identity(const float* block, size_t lane) {
    return std::bit_cast<uint32_t>(block[segment_row::id * kLanes + lane]);
}
HWY_INLINE float offset_in_radii(float side, float radius) {
    return radius > 0 ? std::clamp(side / radius, -1.0f, 1.0f) : 0.0f;
}

/// Hits of some lanes as arrays.
struct HitArrays {
    HWY_ALIGN float t[kLanes], u[kLanes], side[kLanes], radius[kLanes];

    explicit HitArrays(const SegmentHits& hits) {
        const FloatTag d;
        hn::Store(hits.t, d, t);
        hn::Store(hits.u, d, u);
        hn::Store(hits.side, d, side);
        hn::Store(hits.radius, d, radius);
    }
};

/// Round ends whatever the tree's, so that no joint shows a crack. A hit is taken wherever on the ray it lies: the
/// leaf that holds it is asked later, if at all, and says the same up to rounding.
template <bool kVarying>
struct NearestSegment {
    const SegmentScene& scene;
    const LocalRay& ray;
    float t = ray.length;
    uint32_t id = kNone;
    float u = 0, side = 0, radius = 0;

    HWY_INLINE bool leaf(const KdNode& node, float t_in, float t_out) {
        const auto on_hits = [this](const float* block, size_t lane, const SegmentHits& hits) {
            const FloatTag d;
            const Lanes candidates =
                hn::And(hits.met, hn::And(hn::Ge(hits.t, hn::Zero(d)), hn::Le(hits.t, hn::Set(d, t))));
            uint32_t bits = bits_of(candidates);
            if (bits == 0) return false;
            const HitArrays at(hits);
            for (; bits != 0; bits &= bits - 1) {
                const uint32_t k = uint32_t(std::countr_zero(bits));
                const uint32_t other = identity(block, lane + k);
                const bool nearer = at.t[k] < t || (at.t[k] == t && id != kNone && other < id);
                if (!nearer) continue;
                t = at.t[k];
                id = other;
                u = at.u[k];
                side = at.side[k];
                radius = at.radius[k];
            }
            return false;
        };
        const LeafView view(ray, t_in, t_out, scene);
        meet_segments<Ends::round, kVarying>(scene, ray, node, view, on_hits);
        return t < t_out;
    }
};

template <Ends kEnds, bool kVarying>
struct CountCrossings {
    const SegmentScene& scene;
    const LocalRay& ray;
    uint32_t limit;
    uint32_t count = 0;

    HWY_INLINE bool leaf(const KdNode& node, float t_in, float t_out) {
        const auto on_hits = [&](const float* block, size_t lane, const SegmentHits& hits) {
            count += uint32_t(std::popcount(met_within(ray, block, lane, hits, t_in, t_out)));
            return count >= limit;
        };
        return meet_segments<kEnds, kVarying>(scene, ray, node, LeafView(ray, t_in, t_out, scene), on_hits);
    }
};

HWY_INLINE float abs_sin_theta(const LocalRay& ray, const float* block, size_t lane) {
    const float* axis = block + segment_row::dx * kLanes + lane;
    const Vec3 v(axis[0], axis[kLanes], axis[2 * kLanes]);
    const Vec3 d(ray.direction[0], ray.direction[1], ray.direction[2]);
    const float product = ray.squared * dot(v, v);
    return product > 0 ? std::min(std::abs(dot(d, v)) / std::sqrt(product), 1.0f) : 0.0f;
}
HWY_INLINE double least(const glm::dvec3& depth) { return std::min({depth.x, depth.y, depth.z}); }
HWY_INLINE Rgb transmittance_of(const glm::dvec3& depth) {
    return Rgb(std::exp(-depth.x), std::exp(-depth.y), std::exp(-depth.z));
}

template <Ends kEnds, bool kVarying>
struct SumDepths {
    const SegmentScene& scene;
    const LocalRay& ray;
    const Attenuation& attenuation;
    double limit;
    glm::dvec3 depth{0};

    HWY_INLINE bool leaf(const KdNode& node, float t_in, float t_out) {
        const auto on_hits = [&](const float* block, size_t lane, const SegmentHits& hits) {
            for (uint32_t bits = met_within(ray, block, lane, hits, t_in, t_out); bits != 0; bits &= bits - 1) {
                const size_t k = lane + uint32_t(std::countr_zero(bits));
                depth += glm::dvec3(attenuation.depth(identity(block, k), abs_sin_theta(ray, block, k)));
                if (least(depth) > limit) return true;
            }
            return false;
        };
        return meet_segments<kEnds, kVarying>(scene, ray, node, LeafView(ray, t_in, t_out, scene), on_hits);
    }
};

namespace {  // what is made of it is called once in its source, and inlined

/// Takes ray `i` of a batch through the tree: what a query does with its policy. ray_work.cpp has another.
struct PlainWalk {
    template <class Policy>
    HWY_INLINE void operator()(const KdTree& tree, size_t, const LocalRay& ray, Policy& policy) const {
        traverse(tree, ray, policy);
    }
};

}  // namespace

/// Calls run with the tree's ends and radii as template arguments.
template <class Run>
HWY_INLINE void with_shape(const KdTree& tree, const Run& run) {
    const bool varying = tree.leaves.rows == segment_row::kVaryingRadius;
    if (tree.open_ends && varying) return run.template operator()<Ends::open, true>();
    if (tree.open_ends) return run.template operator()<Ends::open, false>();
    if (varying) return run.template operator()<Ends::round, true>();
    run.template operator()<Ends::round, false>();
}

template <bool kVarying, class Walk>
void nearest_segment_of_shape(const KdTree& tree, const RayBatch& rays, const NearestHits& out, const Walk& walk) {
    const SegmentScene scene(tree);
    const auto trace = [&](size_t i, const LocalRay& ray) {
        NearestSegment<kVarying> nearest{scene, ray};
        walk(tree, i, ray, nearest);
        if (nearest.id == kNone) return store_miss(out, i);
        store_hit(out, i, ray.caller_t(nearest.t), nearest.id, nearest.u,
                  offset_in_radii(nearest.side, nearest.radius));
    };
    for_each_ray(tree, rays, trace, [&](size_t i) { store_miss(out, i); });
}

template <class Walk>
void nearest_segment_by(const KdTree& tree, const RayBatch& rays, const NearestHits& out, const Walk& walk) {
    if (tree.leaves.rows == segment_row::kVaryingRadius) return nearest_segment_of_shape<true>(tree, rays, out, walk);
    nearest_segment_of_shape<false>(tree, rays, out, walk);
}
static inline void nearest_segment(const KdTree& tree, const RayBatch& rays, const NearestHits& out) {
    nearest_segment_by(tree, rays, out, PlainWalk{});
}

template <class Walk>
void count_crossings_by(const KdTree& tree, const RayBatch& rays, uint32_t limit, std::span<uint32_t> counts,
                        const Walk& walk) {
    const SegmentScene scene(tree);
    with_shape(tree, [&]<Ends kEnds, bool kVarying>() {
        const auto trace = [&](size_t i, const LocalRay& ray) {
            CountCrossings<kEnds, kVarying> counter{scene, ray, limit};
            walk(tree, i, ray, counter);
            counts[i] = std::min(counter.count, limit);
        };
        for_each_ray(tree, rays, trace, [&](size_t i) { counts[i] = 0; });
    });
}
static inline void count_crossings(const KdTree& tree, const RayBatch& rays, uint32_t limit,
                                   std::span<uint32_t> counts) {
    count_crossings_by(tree, rays, limit, counts, PlainWalk{});
}

static inline void transmittance(const KdTree& tree, const RayBatch& rays, const Attenuation& attenuation, float cutoff,
                                 std::span<Rgb> out) {
    const SegmentScene scene(tree);
    const double limit = -std::log(double(cutoff));
    with_shape(tree, [&]<Ends kEnds, bool kVarying>() {
        const auto trace = [&](size_t i, const LocalRay& ray) {
            SumDepths<kEnds, kVarying> sum{scene, ray, attenuation, limit};
            traverse(tree, ray, sum);
            out[i] = transmittance_of(sum.depth);
        };
        for_each_ray(tree, rays, trace, [&](size_t i) { out[i] = Rgb(1); });
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
