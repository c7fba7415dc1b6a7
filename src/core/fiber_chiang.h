// SPDX-License-Identifier: MIT
// The near field model: the lobes of d'Eon et al. 2011 at one offset h (Zinke & Weber 2007), with the parameters of
// Chiang et al. 2016. f |cos theta_i| = sum over lobes of A_p M_p N_p; the energies A_p sum to one without absorption.
#pragma once

#include "core/fiber.h"

namespace tress {

/// A fiber seen from one direction at one offset.
struct ChiangPoint {
    SinCos inclination[Fiber::kLobes];  // of wo, tilted as the scales do for lobe p
    float azimuth[Fiber::kLobes - 1];   // where lobe p leaves, in [-pi, pi]; the rest leaves all round
    Rgb energy[Fiber::kLobes];          // A_p
    float share[Fiber::kLobes];         // probability of choosing lobe p
};
ChiangPoint make_chiang_point(const Fiber& fiber, const Rgb& sigma_a, const Vec3& wo, float h);

FiberScattering evaluate(const Fiber& fiber, const ChiangPoint& point, const Vec3& wi);
FiberSample evaluate_with_pdf(const Fiber& fiber, const ChiangPoint& point, const Vec3& wi);
Vec3 sample(const Fiber& fiber, const ChiangPoint& point, const glm::vec4& u);

}  // namespace tress
