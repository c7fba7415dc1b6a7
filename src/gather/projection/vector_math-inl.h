// SPDX-License-Identifier: MIT
// Functions of vectors of floats, the same to the bit on every instruction set: no estimates that differ between
// machines, no fused multiply-adds.
#if defined(TRESS_GATHER_PROJECTION_VECTOR_MATH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_GATHER_PROJECTION_VECTOR_MATH_INL_H
#undef TRESS_GATHER_PROJECTION_VECTOR_MATH_INL_H
#else
#define TRESS_GATHER_PROJECTION_VECTOR_MATH_INL_H
#endif

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "gather/projection/polynomials.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

inline constexpr size_t kMostLanes = 16;  // rows of arrays are padded to a multiple of this
using Floats = hn::CappedTag<float, kMostLanes>;
using Ints = hn::RebindToSigned<Floats>;
using FloatVec = hn::Vec<Floats>;
using IntVec = hn::Vec<Ints>;
using FloatMask = hn::Mask<Floats>;

HWY_INLINE FloatVec set(float value) { return hn::Set(Floats(), value); }

/// first, first + 1, ...: Iota of a number that is not constant goes through memory.
HWY_INLINE IntVec counted_from(int32_t first) { return hn::Iota(Ints(), 0) + hn::Set(Ints(), first); }
HWY_INLINE FloatVec counted_from(float first) { return hn::Iota(Floats(), 0.0f) + set(first); }

/// A bit a lane, the first lane's the lowest.
HWY_INLINE uint32_t bits_of(FloatMask mask) {
    uint8_t bytes[8] = {};
    uint16_t bits;  // at most kMostLanes
    hn::StoreMaskBits(Floats(), mask, bytes);
    std::memcpy(&bits, bytes, sizeof(bits));
    return bits;
}

/// c[0] + c[1] x + ...
template <size_t kTerms>
HWY_INLINE FloatVec polynomial(const float (&c)[kTerms], FloatVec x) {
    FloatVec sum = set(c[kTerms - 1]);
    for (size_t i = kTerms - 1; i-- > 0;) sum = sum * x + set(c[i]);
    return sum;
}

/// 1 / sqrt(x) for normal positive x, within 5e-6 of itself: an estimate from the bits of x (Blinn 1997) and two of
/// Newton's steps. Finite, but meaningless, for 0.
template <class D>
HWY_INLINE hn::Vec<D> inverse_sqrt(D d, hn::Vec<D> x) {
    const hn::RebindToSigned<D> di;
    hn::Vec<D> y = hn::BitCast(d, hn::Set(di, 0x5f375a86) - hn::ShiftRight<1>(hn::BitCast(di, x)));
    const hn::Vec<D> half = hn::Set(d, 0.5f) * x, three_halves = hn::Set(d, 1.5f);
    y = y * (three_halves - half * y * y);
    y = y * (three_halves - half * y * y);
    return y;
}
HWY_INLINE FloatVec inverse_sqrt(FloatVec x) { return inverse_sqrt(Floats(), x); }

/// exp(-x) for x >= 0, within 2e-7 of itself; 0 beyond the smallest normal number.
HWY_INLINE FloatVec exp_minus(FloatVec x) {
    const Ints di;
    const FloatVec power = hn::Min(x, set(86.0f)) * set(-1.44269504f);
    const FloatVec whole = hn::Round(power);
    const FloatVec mantissa = polynomial(kExp2Polynomial, power - whole);
    const IntVec exponent = hn::ShiftLeft<23>(hn::ConvertTo(di, whole) + hn::Set(di, 127));
    return hn::IfThenElseZero(x < set(86.0f), mantissa * hn::BitCast(Floats(), exponent));
}

/// Nearest whole number of |x| < 2^21, as std::nearbyint: the sum's last bits are it, where ConvertTo of Highway asks
/// of every lane whether it is too large.
template <class D>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> nearest_int(D d, hn::Vec<D> x) {
    constexpr float kShift = 0x1.8p23f;
    const hn::RebindToSigned<D> di;
    return hn::BitCast(di, x + hn::Set(d, kShift)) - hn::Set(di, std::bit_cast<int32_t>(kShift));
}
HWY_INLINE IntVec nearest_int(FloatVec x) { return nearest_int(Floats(), x); }

/// Azimuth of (x, y) in turns, as turn_of of igloo.h.
HWY_INLINE FloatVec turn_of(FloatVec x, FloatVec y) {
    const FloatVec zero = hn::Zero(Floats());
    const FloatVec ax = hn::Abs(x), ay = hn::Abs(y);
    const FloatVec high = hn::Max(ax, ay), low = hn::Min(ax, ay);
    const FloatVec t = low / hn::Max(high, set(std::numeric_limits<float>::min()));
    const FloatVec octant = polynomial(kTurnPolynomial, t * t) * t;
    const FloatVec quarter = hn::IfThenElse(ay > ax, set(0.25f) - octant, octant);
    const FloatVec half = hn::IfThenElse(x < zero, set(0.5f) - quarter, quarter);
    return hn::IfThenElse(y < zero, set(1.0f) - half, half);
}

/// sin(x) for |x| <= pi / 2.
HWY_INLINE FloatVec sine(FloatVec x) { return polynomial(kSinPolynomial, x * x) * x; }

HWY_INLINE FloatVec dot3(FloatVec ax, FloatVec ay, FloatVec az, FloatVec bx, FloatVec by, FloatVec bz) {
    return ax * bx + ay * by + az * bz;
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
