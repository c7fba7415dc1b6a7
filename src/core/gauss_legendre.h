// SPDX-License-Identifier: MIT
// Gauss-Legendre quadrature.
#pragma once

#include <vector>

namespace tress {

struct QuadratureNode {
    double x, weight;
};

/// Nodes and weights on [lo, hi], in rising order: exact for polynomials up to degree 2 count - 1.
std::vector<QuadratureNode> gauss_legendre(int count, double lo, double hi);

}  // namespace tress
