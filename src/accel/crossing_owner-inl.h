// SPDX-License-Identifier: MIT
// Which leaf a crossing belongs to: the one whose half-open interval of the ray holds its t, so that each counts once.
// A leaf's own t is rounded about the leaf; where that is too near to an end of the interval to tell, leaves decide by
// a t in double that is the same for all of them. Where hair lies exactly in a split plane, every crossing is so near.
#if defined(TRESS_ACCEL_CROSSING_OWNER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_ACCEL_CROSSING_OWNER_INL_H
#undef TRESS_ACCEL_CROSSING_OWNER_INL_H
#else
#define TRESS_ACCEL_CROSSING_OWNER_INL_H
#endif

#include "accel/segment_test-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

/// The closest approach of ray and axis, as meet_segments finds it, from the segment and the ray alone.
inline double exact_t(const LocalRay& ray, const float* block, size_t lane) {
    const float* row = block + lane;
    const DVec3 start(row[segment_row::x * kLanes], row[segment_row::y * kLanes], row[segment_row::z * kLanes]);
    const DVec3 axis(row[segment_row::dx * kLanes], row[segment_row::dy * kLanes], row[segment_row::dz * kLanes]);
    const DVec3 d(ray.direction[0], ray.direction[1], ray.direction[2]);
    const DVec3 a = start - DVec3(ray.origin[0], ray.origin[1], ray.origin[2]), n = cross(d, axis);
    const double squared = dot(d, d), nn = dot(n, n);
    const bool oblique = nn > double(kParallel) * squared * dot(axis, axis);
    const double u = oblique ? glm::clamp(-dot(cross(d, a), n) / nn, 0.0, 1.0) : 0;
    return dot(a + u * axis, d) / squared;
}

/// Of the lanes in `doubtful`, those that lie in [low, high) by exact_t.
inline uint32_t exactly_within(const LocalRay& ray, const float* block, size_t lane, uint32_t doubtful, float low,
                               float high) {
    uint32_t within = 0;
    for (uint32_t bits = doubtful; bits != 0; bits &= bits - 1) {
        const uint32_t k = uint32_t(std::countr_zero(bits));
        const double t = exact_t(ray, block, lane + k);
        if (t >= double(low) && t < double(high)) within |= 1u << k;
    }
    return within;
}

/// Lanes of hits.met from `low` up to, not with, `high`, as bits.
HWY_INLINE uint32_t met_within(const LocalRay& ray, const float* block, size_t lane, const SegmentHits& hits, float low,
                               float high) {
    const FloatTag d;
    constexpr float kRounding = 8 * 0x1p-23f;  // of t: what a leaf's own may be off by
    const Floats rounding = hn::Set(d, kRounding * high);
    const Floats from_low = hn::Sub(hits.t, hn::Set(d, low)), to_high = hn::Sub(hn::Set(d, high), hits.t);
    const Lanes within = hn::And(hits.met, hn::And(hn::Ge(from_low, hn::Zero(d)), hn::Gt(to_high, hn::Zero(d))));
    const Lanes near = hn::Le(hn::Min(hn::Abs(from_low), hn::Abs(to_high)), rounding);
    const uint32_t doubtful = bits_of(hn::And(hits.met, near));
    if (HWY_LIKELY(doubtful == 0)) return bits_of(within);
    return (bits_of(within) & ~doubtful) | exactly_within(ray, block, lane, doubtful, low, high);
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
