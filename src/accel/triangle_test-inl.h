// SPDX-License-Identifier: MIT
// A ray against the triangles of a leaf, watertight after Woop, Benthin, Wald 2013: corners are sheared so that the ray
// runs along an axis, and the edge functions of two triangles that share an edge come from the same numbers there, of
// which one is exactly the negative of the other. Both sides are hit.
#if defined(TRESS_ACCEL_TRIANGLE_TEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_ACCEL_TRIANGLE_TEST_INL_H
#undef TRESS_ACCEL_TRIANGLE_TEST_INL_H
#else
#define TRESS_ACCEL_TRIANGLE_TEST_INL_H
#endif

#include "accel/segment_test-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

/// The shear that makes the ray run along axis z; the same for all triangles that the ray sees.
struct Shear {
    int x, y, z;
    float by_x, by_y, by_z;

    explicit Shear(const LocalRay& ray) {
        const float* d = ray.direction;
        const float ax = std::abs(d[0]), ay = std::abs(d[1]), az = std::abs(d[2]);
        z = ax >= ay && ax >= az ? 0 : (ay >= az ? 1 : 2);
        x = (z + 1) % 3;
        y = (z + 2) % 3;
        by_x = d[x] / d[z];
        by_y = d[y] / d[z];
        by_z = 1 / d[z];
    }
};

struct TriangleHits {
    Lanes met;
    Floats t, u, v;
};

/// Calls on_hits(block, lane, hits) for each vector of lanes, in order, of which some are met, until it returns true;
/// returns whether it did.
template <class OnHits>
HWY_INLINE bool meet_triangles(const KdTree& tree, const LocalRay& ray, const Shear& shear, const KdNode& leaf,
                               const OnHits& on_hits) {
    const FloatTag tag;
    const Floats zero = hn::Zero(tag);
    const auto corner = [&](const float* rows, size_t lane) {  // of three rows: x, y, z of one corner
        const auto part = [&](int axis) {
            return hn::Sub(hn::Load(tag, rows + size_t(axis) * kLanes + lane), hn::Set(tag, ray.plane_origin[axis]));
        };
        const Floats z = part(shear.z);
        return Floats3{hn::Sub(part(shear.x), hn::Mul(hn::Set(tag, shear.by_x), z)),
                       hn::Sub(part(shear.y), hn::Mul(hn::Set(tag, shear.by_y), z)), z};
    };
    const auto edge = [](const Floats3& p, const Floats3& q) { return hn::Sub(hn::Mul(p.x, q.y), hn::Mul(p.y, q.x)); };
    const float* block = tree.leaves.block(leaf.first_block());
    const float* end = block + size_t(blocks_for(leaf.references())) * triangle_row::kRows * kLanes;
    for (; block != end; block += triangle_row::kRows * kLanes) {
        for (size_t lane = 0; lane < kLanes; lane += hn::Lanes(tag)) {
            const Floats3 a = corner(block + triangle_row::ax * kLanes, lane);
            const Floats3 b = corner(block + triangle_row::bx * kLanes, lane);
            const Floats3 c = corner(block + triangle_row::cx * kLanes, lane);
            const Floats of_a = edge(c, b), of_b = edge(a, c), of_c = edge(b, a);
            const Lanes negative = hn::Lt(hn::Min(hn::Min(of_a, of_b), of_c), zero);
            const Lanes positive = hn::Gt(hn::Max(hn::Max(of_a, of_b), of_c), zero);
            const Floats sum = hn::Add(hn::Add(of_a, of_b), of_c);
            Lanes met = hn::AndNot(hn::And(negative, positive), hn::Ne(sum, zero));
            if (hn::AllFalse(tag, met)) continue;
            met = hn::And(met, may_meet(load_identities(block + triangle_row::id * kLanes, lane), ray));
            const Floats depth = hn::Add(hn::Add(hn::Mul(of_a, a.z), hn::Mul(of_b, b.z)), hn::Mul(of_c, c.z));
            const Floats t = hn::Div(hn::Mul(depth, hn::Set(tag, shear.by_z)), sum);
            if (on_hits(block, lane, TriangleHits{met, t, hn::Div(of_b, sum), hn::Div(of_c, sum)})) return true;
        }
    }
    return false;
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
