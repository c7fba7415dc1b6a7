// SPDX-License-Identifier: MIT
// The longitudinal scattering function M of d'Eon et al. 2011: integral of M cos(theta_i) dtheta_i = 1 for any
// theta_o and variance v. Rearranged so that no factor overflows: with a = cos(theta_i) cos(theta_o) / v,
//     M = exp(-2 sin^2((theta_i + theta_o) / 2) / v) I0(a) exp(-a) / (v (1 - exp(-2 / v))).
// Inclinations come as sine and cosine, and 4 sin^2(half their sum) as a squared chord: angles are never formed.
#pragma once

#include "core/math.h"

namespace tress {

struct SinCos {
    float sin = 0, cos = 1;
};

/// Of a direction, from the normal plane of x. Not by 1 - x^2, which knows little of directions near the pole.
inline SinCos inclination_of(const Vec3& w) { return {w.x, std::sqrt(w.y * w.y + w.z * w.z)}; }

/// theta_o moved so that a lobe peaks at theta_i + theta_o = shift. Past the pole it comes back on the other side.
inline SinCos tilted(const SinCos& o, const SinCos& shift) {
    return {o.sin * shift.cos - o.cos * shift.sin, std::abs(o.cos * shift.cos + o.sin * shift.sin)};
}

/// Smallest variance kept: a lobe 1e-3 radians wide, which single precision still resolves.
inline constexpr double kSmallestVariance = 1e-6;

struct LongitudinalLobe {
    float variance = 1;
    float inverse = 1;        // 1 / v
    float normalization = 1;  // 1 / (v (1 - exp(-2 / v)))
};

inline LongitudinalLobe make_longitudinal(double variance) {
    const double v = variance > kSmallestVariance ? variance : kSmallestVariance;
    return {float(v), float(1 / v), float(-1 / (v * std::expm1(-2 / v)))};
}

/// I0(x) exp(-x) = factor exp(exponent), so that a caller who has an exponential to take takes just one.
struct ScaledBessel {
    float factor, exponent;
};

/// For x >= 0 (Abramowitz & Stegun 1964, 9.8.1 and 9.8.2; relative error below 5e-7).
inline ScaledBessel scaled_bessel_i0(float x) {
    constexpr float kJoint = 3.75f;
    if (x < kJoint) {
        const float t = square(x / kJoint);
        const float series =
            1 + t * (3.5156229f +
                     t * (3.0899424f + t * (1.2067492f + t * (0.2659732f + t * (0.0360768f + t * 0.0045813f)))));
        return {series, -x};
    }
    const float t = kJoint / x;
    const float low = 0.39894228f + t * (0.01328592f + t * (0.00225319f + t * (-0.00157565f + t * 0.00916281f)));
    const float high = -0.02057706f + t * (0.02635537f + t * (-0.01647633f + t * 0.00392377f));
    return {(low + square(square(t)) * t * high) / std::sqrt(x), 0};
}

inline float longitudinal(const LongitudinalLobe& lobe, const SinCos& i, const SinCos& o) {
    const float chord2 = square(i.cos - o.cos) + square(i.sin + o.sin);
    const ScaledBessel bessel = scaled_bessel_i0(i.cos * o.cos * lobe.inverse);
    return std::exp(bessel.exponent - 0.5f * chord2 * lobe.inverse) * bessel.factor * lobe.normalization;
}

/// Inclination with density M cos(theta_i), exactly (d'Eon et al. 2013): M is a von Mises-Fisher lobe about the mirror
/// inclination, spun about the fiber. 1 - cos of the angle to the axis is drawn, not the cosine, which would lose sharp
/// lobes to rounding.
inline SinCos sample_longitudinal(const LongitudinalLobe& lobe, const SinCos& o, float u, float v) {
    const float below_one = std::log1p(u * std::expm1(-2 * lobe.inverse));
    const float versine = glm::clamp(-lobe.variance * below_one, 0.0f, 2.0f);
    const float sine = safe_sqrt(versine * (2 - versine));
    const float turn = 2 * kPi * v;
    const float up = sine * std::cos(turn), side = sine * std::sin(turn), along = 1 - versine;
    const float x = up * o.cos - along * o.sin;
    return {glm::clamp(x, -1.0f, 1.0f), std::sqrt(square(along * o.cos + up * o.sin) + square(side))};
}

}  // namespace tress
