// SPDX-License-Identifier: MIT
// A ray made ready for one tree: clipped to its bounds in double, its origin moved to where it enters them, so that
// single precision sees only small numbers however far the ray comes from. Per target: see queries.cpp.
#if defined(TRESS_ACCEL_LOCAL_RAY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_ACCEL_LOCAL_RAY_INL_H
#undef TRESS_ACCEL_LOCAL_RAY_INL_H
#else
#define TRESS_ACCEL_LOCAL_RAY_INL_H
#endif

#include <algorithm>
#include <bit>
#include <cmath>

#include "accel/queries.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

/// Points of the ray are origin + t direction for t in [0, length). The direction is the caller's divided by a power of
/// two, so that its largest component lies in [1, 2): exact, and squares of it neither overflow nor vanish.
struct LocalRay {
    double origin[3];        // relative to tree.origin
    float direction[3];      // exact
    float plane_origin[3];   // origin, rounded: for the distance to split planes and for triangles
    float inverse[3];        // 1 / direction; infinity where that is 0
    uint32_t from_right[3];  // 1 where the ray descends, and so meets the right child first
    float length;
    float squared;       // |direction|^2
    double base, scale;  // caller's t = (base + t) * scale
    uint32_t skip_first, skip_last;

    float caller_t(float t) const { return float((base + double(t)) * scale); }
};

/// Interval of t as it is cut by one pair of planes after another.
struct Interval {
    double in, out;

    void cut(double a, double b) {
        const double lo = a < b ? a : b, hi = a < b ? b : a;
        in = in > lo ? in : lo;
        out = out < hi ? out : hi;
    }
};

/// Bounds in double, grown by a few ulp so that what lies on a face, or in a flat box, is inside.
struct PaddedBounds {
    double lo[3], hi[3];

    explicit PaddedBounds(const Bounds& b) {
        constexpr double kPad = 0x1p-20;  // of the largest coordinate: 16 ulp of single precision
        const double pad = kPad * double(glm::max(max_component(abs(b.lo)), max_component(abs(b.hi))));
        for (int axis = 0; axis < 3; ++axis) {
            lo[axis] = double(b.lo[axis]) - pad;
            hi[axis] = double(b.hi[axis]) + pad;
        }
    }
};

/// The power of two 2^e with 2^e <= value < 2^(e + 1), for a normal positive value.
HWY_INLINE uint64_t exponent_bits(double value) { return std::bit_cast<uint64_t>(value) & 0x7ff0000000000000ull; }

/// False where ray `i` cannot meet anything: it passes the bounds, is not finite, or has no direction or no length.
HWY_INLINE bool make_local_ray(const KdTree& tree, const PaddedBounds& bounds, const RayBatch& rays, size_t i,
                               LocalRay& ray) {
    const double o[3] = {double(rays.ox[i]), double(rays.oy[i]), double(rays.oz[i])};
    const double d[3] = {double(rays.dx[i]), double(rays.dy[i]), double(rays.dz[i])};
    const float t_near = rays.t_near[i], t_far = rays.t_far[i];
    const double largest = std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});  // a NaN is caught below
    const bool finite = std::isfinite(o[0] + o[1] + o[2] + d[0] + d[1] + d[2]);
    if (!finite || !(largest > 0) || !(t_near < t_far)) return false;

    constexpr uint64_t kTwiceBias = 2046ull << 52;
    const uint64_t exponent = exponent_bits(largest);
    const double unit = std::bit_cast<double>(exponent), scale = std::bit_cast<double>(kTwiceBias - exponent);
    Interval t{double(t_near) * unit, double(t_far) * unit};
    double start[3], direction[3], squared = 0;
    for (int axis = 0; axis < 3; ++axis) {
        start[axis] = o[axis] - tree.origin[axis];
        direction[axis] = d[axis] * scale;
        squared += direction[axis] * direction[axis];
        const double to_lo = bounds.lo[axis] - start[axis], to_hi = bounds.hi[axis] - start[axis];
        ray.direction[axis] = float(direction[axis]);
        ray.from_right[axis] = d[axis] < 0;
        if (d[axis] == 0) {
            if (to_lo > 0 || to_hi < 0) return false;
            ray.inverse[axis] = kInfinity;
            continue;
        }
        const double inverse = 1 / direction[axis];
        ray.inverse[axis] = float(inverse);
        t.cut(to_lo * inverse, to_hi * inverse);
    }
    if (!(t.in < t.out)) return false;

    for (int axis = 0; axis < 3; ++axis) {
        ray.origin[axis] = start[axis] + t.in * direction[axis];
        ray.plane_origin[axis] = float(ray.origin[axis]);
    }
    ray.length = float(t.out - t.in);
    ray.squared = float(squared);
    ray.base = t.in;
    ray.scale = scale;
    ray.skip_first = rays.skip_first.empty() ? kNone : rays.skip_first[i];
    ray.skip_last = rays.skip_last.empty() ? kNone : rays.skip_last[i];
    return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
