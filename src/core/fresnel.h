// SPDX-License-Identifier: MIT
// Refraction by a cylinder of dielectric, in the plane across it and in space.
#pragma once

#include "core/math.h"

namespace tress {

/// Reflectance of unpolarised light that meets a dielectric from outside; eta >= 1, cosine of incidence in [0, 1].
inline double fresnel(double eta, double cos_i) {
    if (eta == 1) return 0;
    const double cos_t = std::sqrt(cos_i * cos_i + eta * eta - 1) / eta;
    const double s = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    const double p = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    return 0.5 * (s * s + p * p);
}

/// What inclination alone decides of a path inside: the bend of the ray's projection, and how much longer than it
/// the ray is.
struct Inclination {
    double bravais;  // eta' = sqrt(eta^2 - sin^2) / cos (Marschner et al. 2003): Snell's index of the projection
    double cos_t;    // of the inclination inside
};

inline Inclination refract_inclination(double eta, double cos_theta) {
    constexpr double kLeastCosine = 1e-9;  // grazing: eta' stays finite
    const double cosine = cos_theta > kLeastCosine ? cos_theta : kLeastCosine;
    const double slack = std::sqrt(cosine * cosine + (eta * eta - 1));  // sqrt(eta^2 - sin^2), exact at eta = 1
    return {slack / cosine, slack / eta};
}

/// Length of a path from wall to wall in radii: 2 cos(gamma_t) / cos(theta_t). Marschner et al. 2003 print another.
inline double chord_length(double sin_gamma_t, double cos_theta_t) {
    return 2 * safe_sqrt(1 - sin_gamma_t * sin_gamma_t) / cos_theta_t;
}

/// What absorption leaves over a length; 0 of an infinite absorption, 1 of none, whatever the length.
inline double transmitted(double sigma_a, double length) {
    if (!(sigma_a > 0)) return 1;
    if (std::isinf(sigma_a)) return 0;
    return std::exp(-sigma_a * length);
}

}  // namespace tress
