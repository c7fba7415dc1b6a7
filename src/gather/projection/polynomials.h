// SPDX-License-Identifier: MIT
// Coefficients of the functions that projection needs, least squares reweighted towards the least greatest error; in
// one place for scalar and vector code.
#pragma once

namespace tress {

/// atan(t) / (2 pi) = t (c0 + c1 t^2 + ...) for t in [0, 1], within 3e-7; at t = 1 it is 1/8.
inline constexpr float kTurnPolynomial[] = {0.15915106967563483f,  -0.05293257602168525f, 0.030763646631322944f,
                                            -0.01842727287509236f, 0.008263879956953043f, -0.0018187473671332118f};

/// sin(x) = x (c0 + c1 x^2 + ...) for |x| <= pi / 2, within 4e-9 before rounding.
inline constexpr float kSinPolynomial[] = {0.999999974087323f, -0.16666646026693402f, 0.0083328727120529f,
                                           -0.0001979923958596438f, 2.587161117138803e-06f};

/// 2^x = c0 + c1 x + ... for |x| <= 1/2, within 2e-9 of itself before rounding.
inline constexpr float kExp2Polynomial[] = {1.000000000554169f,     0.6931472057372683f,   0.24022646890628635f,
                                            0.055503287769646324f,  0.009618488957665108f, 0.001339993121975372f,
                                            0.00015345811868417401f};

}  // namespace tress
