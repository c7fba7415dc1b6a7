// SPDX-License-Identifier: MIT
#include "core/marschner_azimuthal.h"

#include <algorithm>
#include <numbers>

#include "core/depressed_cubic.h"
#include "core/fresnel.h"
#include "core/lobe_energy.h"

namespace tress {
namespace {

constexpr double kPiD = std::numbers::pi;

/// Least |dphi/dgamma|: bounds the peaks where the paper has no treatment (TT of an index below 2 / sqrt(3), where the
/// cubic folds over). Of the energy it takes less than one part in a hundred.
constexpr double kLeastSlope = 0.01;

// Of the caustics (table 1 of the paper).
constexpr double kGlintScale = 0.5;  // k_G: 0.5 gives back just the energy that is taken from the peaks
constexpr double kGlintSpan = 0.5;   // Delta h_M
constexpr double kFadeIndex = 0.2;   // Delta eta': over which the merged caustic fades
constexpr double kMergingIndex = 2;  // eta' at which the two caustics of TRT meet

/// phi - p pi = a gamma - b gamma^3: where light that entered at gamma leaves after p chords (eq. 10 of the paper).
struct Exit {
    double a, b;

    double at(double gamma) const { return gamma * (a - b * gamma * gamma); }
    double slope(double gamma) const { return a - 3 * b * gamma * gamma; }
    /// Largest |phi - p pi| reached: at the rim or at the fold.
    double reach() const {
        const double fold = a > 0 ? std::min(std::sqrt(a / (3 * b)), kPiD / 2) : 0;
        return std::max(std::abs(at(kPiD / 2)), std::abs(at(fold)));
    }
};

Exit make_exit(const CrossSection& section, int p) {
    const double pc = p * section.c;
    return {6 * pc / kPiD - 2, 8 * pc / (kPiD * kPiD * kPiD)};
}

/// A_p of lobe p at gamma.
Rgb energy_at(const CrossSection& section, const Rgb& sigma_a, int p, double gamma) {
    const double sine = std::sin(gamma);
    const double f = reflectance(section, sine, std::cos(gamma));
    const double length = path_length(section, sine);
    Rgb energy;
    for (int channel = 0; channel < 3; ++channel)
        energy[channel] = float(lobe_energy(f, transmitted(double(sigma_a[channel]), length)).of[p]);
    return energy;
}

/// Sum over the paths that leave at `turn` = phi - p pi, and whole turns from it.
Rgb sum_paths(const CrossSection& section, const Rgb& sigma_a, int p, double turn) {
    const Exit exit = make_exit(section, p);
    const double reach = exit.reach();
    Rgb sum(0);
    for (int k = -1; k <= 1; ++k) {
        if (std::abs(turn + 2 * kPiD * k) > reach) continue;
        const CubicRoots roots = solve_depressed_cubic(exit.a, exit.b, turn + 2 * kPiD * k);
        for (int i = 0; i < roots.count; ++i) {
            const double gamma = roots.root[i];
            if (!(std::abs(gamma) < kPiD / 2)) continue;
            const double slope = std::max(std::abs(exit.slope(gamma)), kLeastSlope);
            sum += float(std::cos(gamma) / (2 * slope)) * energy_at(section, sigma_a, p, gamma);
        }
    }
    return sum;
}

/// The pair of peaks at +-phi of TRT, and what takes their place.
struct Caustic {
    double phi, gamma;
    double span;  // Delta h
    double fade;  // t, 1: fully treated
};

Caustic find_caustic(const CrossSection& section, double width) {
    const double past = (section.bravais - kMergingIndex) / kFadeIndex;
    if (past >= 0) {
        const double t = std::min(past, 1.0);
        return {0, 0, kGlintSpan, 1 - t * t * (3 - 2 * t)};
    }
    const Exit exit = make_exit(section, 2);
    const double gamma = std::sqrt(exit.a / (3 * exit.b));  // of the cubic itself, so that its peak is met exactly
    const double bend = 6 * exit.b * gamma / square(std::cos(gamma));  // |d^2 phi / dh^2| where dphi/dh = 0
    return {exit.at(gamma), gamma, std::min(kGlintSpan, 2 * std::sqrt(2 * width / bend)), 1};
}

double bell(double x, double width) { return std::exp(-0.5 * square(x / width)); }

double wrapped(double angle) { return std::remainder(angle, 2 * kPiD); }

}  // namespace

CrossSection make_cross_section(double eta, double cos_theta_d) {
    const Inclination inside = refract_inclination(eta, cos_theta_d);
    return {inside.bravais, eta * eta / inside.bravais, inside.cos_t, std::asin(std::min(1.0, 1 / inside.bravais))};
}

double reflectance(const CrossSection& section, double sin_gamma, double cos_gamma) {
    if (section.bravais == 1) return 0;
    const double cos_t = safe_sqrt(1 - square(sin_gamma / section.bravais));
    const double s = (cos_gamma - section.bravais * cos_t) / (cos_gamma + section.bravais * cos_t);
    const double p = (section.parallel * cos_gamma - cos_t) / (section.parallel * cos_gamma + cos_t);
    return 0.5 * (s * s + p * p);
}

double path_length(const CrossSection& section, double sin_gamma) {
    return chord_length(sin_gamma / section.bravais, section.cos_theta_t);
}

double azimuthal_r(const CrossSection& section, double phi) {
    const double sine = std::sin(phi / 2), cosine = std::cos(phi / 2);  // gamma = phi / 2
    return 0.25 * std::abs(cosine) * reflectance(section, sine, std::abs(cosine));
}

Rgb azimuthal_tt(const CrossSection& section, const Rgb& sigma_a, double phi) {
    return sum_paths(section, sigma_a, 1, wrapped(phi - kPiD));
}

Rgb azimuthal_trt(const CrossSection& section, const Rgb& sigma_a, double phi, double caustic_width) {
    const Caustic caustic = find_caustic(section, caustic_width);
    const double left = bell(wrapped(phi + caustic.phi), caustic_width);
    const double right = bell(wrapped(phi - caustic.phi), caustic_width);
    const double kept = (1 - caustic.fade * left) * (1 - caustic.fade * right);
    const double glint =
        caustic.fade * kGlintScale * caustic.span * (left + right) / (caustic_width * std::sqrt(2 * kPiD));
    return float(kept) * sum_paths(section, sigma_a, 2, phi) +
           float(glint) * energy_at(section, sigma_a, 2, caustic.gamma);
}

}  // namespace tress
