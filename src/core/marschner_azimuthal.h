// SPDX-License-Identifier: MIT
// The azimuthal functions N_p of Marschner et al. 2003: light spread over the whole width of the fiber.
// Integral of N_p over phi = the energy A_p averaged over h in [-1, 1].
#pragma once

#include "core/fiber.h"

namespace tress {

/// The cross-section as the projection of a ray of half difference angle theta_d sees it.
struct CrossSection {
    double bravais;      // eta', for polarisation across the plane
    double parallel;     // eta'', for polarisation in it
    double cos_theta_t;  // of the inclination inside
    double c;            // asin(1 / eta')
};
CrossSection make_cross_section(double eta, double cos_theta_d);

/// Reflectance at the angle gamma from the normal of the cross-section, by the two Bravais indices.
double reflectance(const CrossSection& section, double sin_gamma, double cos_gamma);
/// Path between walls, in radii, of what entered at sin(gamma) = h.
double path_length(const CrossSection& section, double sin_gamma);

/// phi in [-pi, pi] is the azimuth from wo to wi.
double azimuthal_r(const CrossSection& section, double phi);
Rgb azimuthal_tt(const CrossSection& section, const Rgb& sigma_a, double phi);
/// `caustic_width`: radians of the blur that takes the place of the infinite peaks (w_c of the paper).
Rgb azimuthal_trt(const CrossSection& section, const Rgb& sigma_a, double phi, double caustic_width);

}  // namespace tress
