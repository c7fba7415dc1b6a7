// SPDX-License-Identifier: MIT
// The far field model of Marschner et al. 2003: R, TT and TRT averaged over the width of the fiber, so h is not read.
// f = sum over lobes of M_p N_p / cos^2(theta_d). M_p is a Gaussian of theta_h about half the lobe's shift, half as
// wide as the deviation sqrt(v_p) of theta_i + theta_o in the near field model, so that both look alike at equal
// beta_m (TT half and TRT twice as wide as R, as in the paper). It is normalised over theta_i = 2 theta_h - theta_o:
// the paper's, over theta_h, would scatter twice the light. The model does not conserve energy.
#pragma once

#include "core/fiber.h"

namespace tress {

/// A fiber seen from one direction.
struct MarschnerPoint {
    SinCos inclination[Fiber::kLobes];  // of wo, tilted as the scales do for lobe p
    float theta, phi;                   // of wo
    Rgb sigma_a;
    float share[Fiber::kLobes];  // probability of choosing lobe p
};
MarschnerPoint make_marschner_point(const Fiber& fiber, const Rgb& sigma_a, const Vec3& wo);

FiberScattering evaluate(const Fiber& fiber, const MarschnerPoint& point, const Vec3& wi);
FiberSample evaluate_with_pdf(const Fiber& fiber, const MarschnerPoint& point, const Vec3& wi);
Vec3 sample(const Fiber& fiber, const MarschnerPoint& point, const glm::vec4& u);

/// M_p cos(theta_i) / cos^2(theta_d): what inclinations alone say of f |cos theta_i|.
double marschner_longitudinal(const Fiber& fiber, int lobe, double theta_i, double theta_o);
/// cos of the half difference angle, floored where both directions run along the fiber.
double marschner_cos_theta_d(double theta_i, double theta_o);

}  // namespace tress
