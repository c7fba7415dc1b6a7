// SPDX-License-Identifier: MIT
// A ray against the segments of a leaf: ray-facing ribbons, hit where the ray passes within the radius of the axis.
// A line test that never loses a hit goes first; only where a lane passes it is the closest approach worked out.
#if defined(TRESS_ACCEL_SEGMENT_TEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_ACCEL_SEGMENT_TEST_INL_H
#undef TRESS_ACCEL_SEGMENT_TEST_INL_H
#else
#define TRESS_ACCEL_SEGMENT_TEST_INL_H
#endif

#include "accel/local_ray-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::CappedTag<float, kLanes>;
using UintTag = hn::RebindToUnsigned<FloatTag>;
using Floats = hn::Vec<FloatTag>;
using Uints = hn::Vec<UintTag>;
using Lanes = hn::Mask<FloatTag>;

struct Floats3 {
    Floats x, y, z;
};
HWY_INLINE Floats3 spread(const float* v) {
    const FloatTag d;
    return {hn::Set(d, v[0]), hn::Set(d, v[1]), hn::Set(d, v[2])};
}
/// Three rows that follow one another in a block, from `lane` on.
HWY_INLINE Floats3 load_rows(const float* rows, size_t lane) {
    const FloatTag d;
    return {hn::Load(d, rows + lane), hn::Load(d, rows + kLanes + lane), hn::Load(d, rows + 2 * kLanes + lane)};
}
HWY_INLINE Uints load_identities(const float* row, size_t lane) {
    return hn::BitCast(UintTag(), hn::Load(FloatTag(), row + lane));
}
HWY_INLINE Floats3 operator-(const Floats3& a, const Floats3& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Floats3 operator+(const Floats3& a, const Floats3& b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Floats3 operator*(const Floats& s, const Floats3& a) {
    return {hn::Mul(s, a.x), hn::Mul(s, a.y), hn::Mul(s, a.z)};
}
HWY_INLINE Floats dot(const Floats3& a, const Floats3& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Floats3 cross(const Floats3& a, const Floats3& b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}
HWY_INLINE uint32_t bits_of(const Lanes& mask) {
    uint8_t bytes[8] = {};
    hn::StoreMaskBits(FloatTag(), mask, bytes);
    return uint32_t(bytes[0]) | uint32_t(bytes[1]) << 8;
}
/// Lanes that the ray may meet: not padding, not skipped.
HWY_INLINE Lanes may_meet(const Uints& id, const LocalRay& ray) {
    const UintTag d;
    const auto before = hn::Lt(id, hn::Set(d, ray.skip_first)), after = hn::Gt(id, hn::Set(d, ray.skip_last));
    const auto wanted = hn::And(hn::Or(before, after), hn::Ne(id, hn::Set(d, kNone)));
    return hn::RebindMask(FloatTag(), wanted);
}

/// How the ends of a segment are met. Round: the axis ends there, the radius does not. Open: the closest approach lies
/// in [0, 1) of the axis, so that of two segments that share an end only one is met there.
enum class Ends { round, open };

inline constexpr float kParallel = 1e-12f;  // squared sine between ray and axis below which they are parallel

/// What the ray does at the segments of some lanes; lanes not in `met` hold anything.
struct SegmentHits {
    Lanes met;
    Floats t, u;          // t is the local ray's
    Floats side, radius;  // signed offset and radius where it is met, along normalize(cross(direction, axis))
};

/// What all rays of a batch share.
struct SegmentScene {
    const KdTree& tree;
    float longest;   // no segment is longer
    float rounding;  // no point of the tree moves further when it is rounded

    explicit SegmentScene(const KdTree& t)
        : tree(t), longest(t.longest_segment > 0 ? t.longest_segment : length(t.bounds.extent())) {
        const float largest = glm::max(max_component(abs(t.bounds.lo)), max_component(abs(t.bounds.hi)));
        rounding = 3 * 0x1p-23f * largest;  // half an ulp an axis, doubled for what lies a little outside
    }
};

/// The leaf as seen from the middle of the ray's interval in it: what is subtracted is near what it is subtracted from.
struct LeafView {
    double point[3];
    float middle[3];  // point, rounded
    float t;
    float slack;  // of the line test's squared triple product

    LeafView(const LocalRay& ray, float t_in, float t_out, const SegmentScene& scene) {
        t = 0.5f * (t_in + t_out);
        for (int axis = 0; axis < 3; ++axis) {
            point[axis] = ray.origin[axis] + double(t) * double(ray.direction[axis]);
            middle[axis] = float(point[axis]);
        }
        // Rounding moves the triple product of the line test by at most kRounding |start - middle| |d| |axis|. Where
        // ray and axis are nearly parallel that is more than the radius allows.
        constexpr float kRounding = 4 * 0x1p-23f;
        const float reach = scene.longest + 4 * (t_out - t);  // |d| is below 2 sqrt(3)
        slack = square(kRounding * reach * scene.longest) * (4 * ray.squared);
    }
    /// What was lost in rounding: middle + rest is the point to twice single precision.
    Floats3 rest() const {
        float values[3];
        for (int axis = 0; axis < 3; ++axis) values[axis] = float(point[axis] - double(middle[axis]));
        return spread(values);
    }
};

/// Calls on_hits(block, lane, hits) for each vector of lanes, in order, of which some are met, until it returns true;
/// returns whether it did.
template <Ends kEnds, bool kVarying, class OnHits>
HWY_INLINE bool meet_segments(const SegmentScene& scene, const LocalRay& ray, const KdNode& leaf, const LeafView& view,
                              const OnHits& on_hits) {
    const FloatTag tag;
    const Floats zero = hn::Zero(tag), one = hn::Set(tag, 1.0f);
    const Floats3 d = spread(ray.direction), middle = spread(view.middle);
    const Floats widening = hn::Set(tag, scene.rounding), slack = hn::Set(tag, view.slack);
    const float inverse_squared = 1 / ray.squared;
    constexpr uint32_t kRows = kVarying ? segment_row::kVaryingRadius : segment_row::kConstantRadius;
    const float* block = scene.tree.leaves.block(leaf.first_block());
    const float* last = block + size_t(blocks_for(leaf.references())) * kRows * kLanes;
    for (; block != last; block += kRows * kLanes) {
        for (size_t lane = 0; lane < kLanes; lane += hn::Lanes(tag)) {
            const Floats3 start = load_rows(block + segment_row::x * kLanes, lane) - middle;
            const Floats3 axis = load_rows(block + segment_row::dx * kLanes, lane);
            const Floats start_radius = hn::Load(tag, block + segment_row::radius * kLanes + lane);
            Floats slope = zero, largest = hn::Add(start_radius, widening);
            if constexpr (kVarying) {
                slope = hn::Load(tag, block + segment_row::radius_slope * kLanes + lane);
                largest = hn::Add(largest, hn::Max(slope, zero));
            }
            const Floats3 n = cross(d, axis);
            const Floats line = dot(start, n), nn = dot(n, n);
            const Lanes near = hn::Le(hn::Mul(line, line), hn::Add(hn::Mul(hn::Mul(largest, largest), nn), slack));
            if (HWY_LIKELY(hn::AllFalse(tag, near))) continue;

            // Closest approach: u of the axis, then the part across the ray of the point there. An axis that is
            // parallel to the ray up to rounding is met at its start.
            const Floats3 rest = view.rest();
            const Floats3 a = start - rest;
            const Lanes oblique = hn::Gt(nn, hn::Mul(hn::Set(tag, kParallel * ray.squared), dot(axis, axis)));
            const Floats from_start = dot(cross(d, a), n);
            const Floats u_line = hn::IfThenElseZero(oblique, hn::Neg(hn::Div(from_start, nn)));
            const Floats u = hn::Min(hn::Max(u_line, zero), one);
            const Floats3 closest = a + u * axis;
            const Floats t = hn::Mul(dot(closest, d), hn::Set(tag, inverse_squared));
            const Floats3 across = closest - t * d;
            const Floats radius = kVarying ? hn::Add(start_radius, hn::Mul(u, slope)) : start_radius;
            Lanes met = hn::And(near, hn::Lt(dot(across, across), hn::Mul(radius, radius)));  // never of radius 0
            if constexpr (kEnds == Ends::open) {
                // 0 <= u < 1, asked at the ends: of two segments that share one, both see the same numbers there.
                const Floats3 end = load_rows(block + segment_row::x * kLanes, lane) + axis;
                const Floats3 b = (end - middle) - rest;
                const Floats from_end = dot(cross(d, b), n);
                const Lanes inside = hn::And(hn::Le(from_start, zero), hn::Gt(from_end, zero));
                met = hn::And(met, hn::Or(inside, hn::Not(oblique)));
            }
            if (hn::AllFalse(tag, met)) continue;
            met = hn::And(met, may_meet(load_identities(block + segment_row::id * kLanes, lane), ray));
            const Floats side = hn::IfThenElseZero(oblique, hn::Neg(hn::Div(dot(a, n), hn::Sqrt(nn))));
            if (on_hits(block, lane, SegmentHits{met, hn::Add(t, hn::Set(tag, view.t)), u, side, radius})) return true;
        }
    }
    return false;
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
