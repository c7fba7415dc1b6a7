// SPDX-License-Identifier: MIT
#include "core/gauss_legendre.h"

#include <cmath>
#include <numbers>

namespace tress {
namespace {

struct Legendre {
    double value, slope;
};

/// The Legendre polynomial of degree n > 0 and its derivative, by the three-term recurrence; |x| < 1.
Legendre legendre(int n, double x) {
    double before = 1, value = x;
    for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
    }
    return {value, n * (x * value - before) / (x * x - 1)};
}

}  // namespace

std::vector<QuadratureNode> gauss_legendre(int count, double lo, double hi) {
    constexpr int kNewtonSteps = 4;  // from the guess below, three reach double precision
    std::vector<QuadratureNode> nodes;
    nodes.reserve(size_t(count));
    for (int i = 0; i < count; ++i) {
        double x = -std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
        for (int step = 0; step < kNewtonSteps; ++step) {
            const Legendre at = legendre(count, x);
            x -= at.value / at.slope;
        }
        const double slope = legendre(count, x).slope;
        const double half = 0.5 * (hi - lo);
        nodes.push_back({lo + half * (1 + x), half * 2 / ((1 - x * x) * slope * slope)});
    }
    return nodes;
}

}  // namespace tress
