// SPDX-License-Identifier: MIT
// What reversing the light does to f |cos theta_i|, over random pairs of directions.
#pragma once

#include "tools/check/support/fiber_quadrature.h"

namespace tress {

struct Asymmetry {
    double of_sums = 0;  // mean |there - back| over the mean of there + back
    double largest = 0;  // of one pair, |there - back| over there + back
};

class AsymmetryMeter {
public:
    void add(double there, double back) {
        const double difference = std::abs(there - back), sum = there + back;
        difference_ += difference;
        sum_ += sum;
        if (sum > 0) largest_ = std::max(largest_, difference / sum);
    }
    Asymmetry result() const { return {sum_ > 0 ? difference_ / sum_ : 0, largest_}; }

private:
    double difference_ = 0, sum_ = 0, largest_ = 0;
};

inline float red(const FiberScattering& s) { return s.forward.x + s.reflected.x; }

/// f |cos theta_i| averaged over h: at one h the reversed light meets the fiber elsewhere.
inline double over_width(const Fiber& fiber, const Vec3& o, const Vec3& i) {
    static const std::vector<QuadratureNode> offsets = gauss_legendre(48, -1, 1);
    double sum = 0;
    for (const QuadratureNode& h : offsets)
        sum += 0.5 * h.weight * double(red(evaluate(fiber, fiber.parameters.sigma_a, o, i, float(h.x))));
    return sum;
}

/// At the inclination of `a` to the other side, at the azimuth of `b`.
inline Vec3 at_opposite_inclination(const Vec3& a, const Vec3& b) {
    return direction(-std::asin(double(a.x)), std::atan2(double(b.z), double(b.y)));
}

struct Reciprocity {
    Asymmetry glassless;  // at an index of 1, at one h: nothing but M depends on theta_o
    Asymmetry opposite;   // averaged over h, |theta_i| = |theta_o|
    Asymmetry any;        // averaged over h
};

/// Of the near field at its default roughness, without tilt.
inline Reciprocity near_field_reciprocity(uint64_t pairs) {
    FiberParameters q;
    q.alpha_degrees = 0;
    q.sigma_a = Rgb(0.3f);
    const Fiber fiber = make_fiber(q);
    q.sigma_a = Rgb(0);
    q.eta = 1;
    const Fiber glass = make_fiber(q);
    AsymmetryMeter glassless, opposite, any;
    for (uint64_t k = 0; k < pairs; ++k) {
        const Vec3 a = uniform_direction(hash(3, 2 * k)), b = uniform_direction(hash(3, 2 * k + 1));
        const Vec3 c = at_opposite_inclination(a, b);
        glassless.add(double(evaluate(glass, Rgb(0), a, b, 0.3f).forward.x),
                      double(evaluate(glass, Rgb(0), b, a, 0.3f).forward.x));
        opposite.add(over_width(fiber, a, c), over_width(fiber, c, a));
        any.add(over_width(fiber, a, b), over_width(fiber, b, a));
    }
    return {glassless.result(), opposite.result(), any.result()};
}

/// Of the far field's f itself, whatever the tilt: its lobes depend on the sum and the difference of inclinations.
inline Asymmetry far_field_reciprocity(uint64_t pairs) {
    FiberParameters q;
    q.model = FiberModel::marschner;
    q.sigma_a = Rgb(0.3f);
    const Fiber fiber = make_fiber(q);
    AsymmetryMeter meter;
    for (uint64_t k = 0; k < pairs; ++k) {
        const Vec3 a = uniform_direction(hash(4, 2 * k)), b = uniform_direction(hash(4, 2 * k + 1));
        const double cos_a = std::hypot(double(a.y), double(a.z)), cos_b = std::hypot(double(b.y), double(b.z));
        meter.add(double(red(evaluate(fiber, q.sigma_a, a, b, 0))) / cos_b,
                  double(red(evaluate(fiber, q.sigma_a, b, a, 0))) / cos_a);
    }
    return meter.result();
}

}  // namespace tress
