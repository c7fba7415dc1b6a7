// SPDX-License-Identifier: MIT
// Queries that list what a ray crosses, in order.
#if defined(TRESS_ACCEL_CROSSING_QUERIES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_ACCEL_CROSSING_QUERIES_INL_H
#undef TRESS_ACCEL_CROSSING_QUERIES_INL_H
#else
#define TRESS_ACCEL_CROSSING_QUERIES_INL_H
#endif

#include <algorithm>
#include <vector>

#include "accel/segment_queries-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

struct Crossing {
    float t, u, h;  // t as the caller sees it: rounding may make two of them equal
    uint32_t id;

    bool operator<(const Crossing& other) const { return t < other.t || (t == other.t && id < other.id); }
};

/// Calls `on_crossing(crossing, lane in the block)` for each that lies in [t_in, t_out).
template <class OnCrossing>
HWY_INLINE void for_each_crossing(const LocalRay& ray, const float* block, size_t lane, const SegmentHits& hits,
                                  float t_in, float t_out, const OnCrossing& on_crossing) {
    uint32_t bits = met_within(ray, block, lane, hits, t_in, t_out);
    if (bits == 0) return;
    const HitArrays at(hits);
    for (; bits != 0; bits &= bits - 1) {
        const uint32_t k = uint32_t(std::countr_zero(bits));
        const float t = std::clamp(at.t[k], t_in, t_out);  // in the order of leaves, whatever the rounding
        on_crossing(
            Crossing{ray.caller_t(t), at.u[k], offset_in_radii(at.side[k], at.radius[k]), identity(block, lane + k)},
            lane + k);
    }
}

template <Ends kEnds, bool kVarying>
struct CollectCrossings {
    const SegmentScene& scene;
    const LocalRay& ray;
    std::vector<Crossing>& found;

    HWY_INLINE bool leaf(const KdNode& node, float t_in, float t_out) {
        const auto on_hits = [&](const float* block, size_t lane, const SegmentHits& hits) {
            for_each_crossing(ray, block, lane, hits, t_in, t_out,
                              [&](const Crossing& crossing, size_t) { found.push_back(crossing); });
            return false;
        };
        return meet_segments<kEnds, kVarying>(scene, ray, node, LeafView(ray, t_in, t_out, scene), on_hits);
    }
};

struct DeepCrossing : Crossing {
    Rgb depth;
};

/// Stops after the leaf in which the ray has grown deep enough: nearer crossings lie in no later one.
template <Ends kEnds, bool kVarying>
struct CollectFlight {
    const SegmentScene& scene;
    const LocalRay& ray;
    const Attenuation& attenuation;
    double limit;
    std::vector<DeepCrossing>& found;
    glm::dvec3 depth{0};

    HWY_INLINE bool leaf(const KdNode& node, float t_in, float t_out) {
        const auto on_hits = [&](const float* block, size_t lane, const SegmentHits& hits) {
            for_each_crossing(ray, block, lane, hits, t_in, t_out, [&](const Crossing& crossing, size_t k) {
                const Rgb own = attenuation.depth(crossing.id, abs_sin_theta(ray, block, k));
                depth += glm::dvec3(own);
                found.push_back({crossing, own});
            });
            return false;
        };
        meet_segments<kEnds, kVarying>(scene, ray, node, LeafView(ray, t_in, t_out, scene), on_hits);
        return least(depth) > limit;
    }
};

void append_to(Crossings& out, const Crossing& c) {
    out.t.push_back(c.t);
    out.u.push_back(c.u);
    out.h.push_back(c.h);
    out.id.push_back(c.id);
}

void crossings(const KdTree& tree, const RayBatch& rays, Crossings& out) {
    const SegmentScene scene(tree);
    std::vector<Crossing> found;
    const auto append = [&] {
        std::sort(found.begin(), found.end());
        for (const Crossing& c : found) append_to(out, c);
        out.first.push_back(out.t.size());
    };
    with_shape(tree, [&]<Ends kEnds, bool kVarying>() {
        const auto trace = [&](size_t, const LocalRay& ray) {
            found.clear();
            CollectCrossings<kEnds, kVarying> collector{scene, ray, found};
            traverse(tree, ray, collector);
            append();
        };
        for_each_ray(tree, rays, trace, [&](size_t) { out.first.push_back(out.t.size()); });
    });
}

void flights(const KdTree& tree, const RayBatch& rays, const Attenuation& attenuation, std::span<const float> cutoff,
             Flights& out) {
    const SegmentScene scene(tree);
    std::vector<DeepCrossing> found;
    const auto append = [&](double limit) {
        std::sort(found.begin(), found.end());
        glm::dvec3 depth(0);
        Rgb before(1);
        for (const DeepCrossing& c : found) {
            if (least(depth) > limit) break;
            depth += glm::dvec3(c.depth);
            append_to(out.crossings, c);
            out.before.push_back(before);
            out.after.push_back(before = transmittance_of(depth));
        }
    };
    with_shape(tree, [&]<Ends kEnds, bool kVarying>() {
        const auto trace = [&](size_t i, const LocalRay& ray) {
            found.clear();
            const double limit = -std::log(double(cutoff[i]));
            CollectFlight<kEnds, kVarying> collector{scene, ray, attenuation, limit, found};
            traverse(tree, ray, collector);
            append(limit);
            out.crossings.first.push_back(out.crossings.t.size());
        };
        for_each_ray(tree, rays, trace, [&](size_t) { out.crossings.first.push_back(out.crossings.t.size()); });
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
