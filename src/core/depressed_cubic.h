// SPDX-License-Identifier: MIT
// Real roots of a x - b x^3 = y.
#pragma once

#include <cmath>
#include <numbers>

namespace tress {

struct CubicRoots {
    int count = 0;
    double root[3];
};

/// b > 0. Trigonometric and hyperbolic forms: no differences of nearly equal numbers, so b may be tiny.
inline CubicRoots solve_depressed_cubic(double a, double b, double y) {
    CubicRoots roots;
    if (a == 0) {
        roots.root[roots.count++] = -std::cbrt(y / b);
        return roots;
    }
    const double radius = 2 * std::sqrt(std::abs(a) / (3 * b));
    const double ratio = 3 * y / (std::abs(a) * radius);  // y over the height of the local extrema (a > 0)
    if (a < 0) {
        roots.root[roots.count++] = -radius * std::sinh(std::asinh(ratio) / 3);
    } else if (std::abs(ratio) > 1) {
        roots.root[roots.count++] = std::copysign(radius * std::cosh(std::acosh(std::abs(ratio)) / 3), -ratio);
    } else {
        const double third = std::asin(ratio) / 3;  // x = radius sin(t): sin(3 t) = ratio
        for (int k = -1; k <= 1; ++k)
            roots.root[roots.count++] = radius * std::sin(third + 2 * std::numbers::pi * k / 3);
    }
    return roots;
}

}  // namespace tress
