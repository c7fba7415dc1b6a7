// SPDX-License-Identifier: MIT
// The far field model: its azimuthal functions, its caustics, and the energy that it does not conserve.
#include "core/fiber_marschner.h"

#include <doctest/doctest.h>

#include "core/fresnel.h"
#include "core/marschner_azimuthal.h"
#include "tools/check/support/fiber_quadrature.h"

using namespace tress;

namespace {

/// Integral over phi of N, and the energy of its lobe averaged over h.
struct Energies {
    double around = 0, exact = 0;
};

template <class Azimuthal>
Energies energies(const CrossSection& section, double sigma_a, int p, const Azimuthal& azimuthal_function) {
    constexpr int kAzimuths = 20000;
    Energies energy;
    for (int k = 0; k < kAzimuths; ++k)
        energy.around += azimuthal_function(-kPiD + 2 * kPiD * (k + 0.5) / kAzimuths) * 2 * kPiD / kAzimuths;
    for (const QuadratureNode& gamma : gauss_legendre(64, 0, kPiD / 2)) {
        const double f = reflectance(section, std::sin(gamma.x), std::cos(gamma.x));
        const double t = transmitted(sigma_a, path_length(section, std::sin(gamma.x)));
        const double a = p == 0 ? f : square(1 - f) * std::pow(f, p - 1) * std::pow(t, p);
        energy.exact += gamma.weight * std::cos(gamma.x) * a;
    }
    return energy;
}

}  // namespace

TEST_CASE("azimuthal functions integrate to the energy of their lobe over the fiber's width") {
    for (const double eta : {1.2, 1.55, 1.9, 2.5})
        for (const double cosine : {1.0, 0.6, 0.2})
            for (const double sigma_a : {0.0, 0.7}) {
                const CrossSection section = make_cross_section(eta, cosine);
                const Rgb sigma = Rgb(float(sigma_a));
                CAPTURE(eta);
                CAPTURE(cosine);
                CAPTURE(sigma_a);
                const Energies r = energies(section, sigma_a, 0, [&](double phi) { return azimuthal_r(section, phi); });
                CHECK(r.around == doctest::Approx(r.exact).epsilon(1e-4));
                const Energies tt = energies(section, sigma_a, 1,
                                             [&](double phi) { return double(azimuthal_tt(section, sigma, phi).x); });
                CHECK(tt.around == doctest::Approx(tt.exact).epsilon(2e-3));  // 20000 midpoints against a steep edge
                const Energies trt = energies(
                    section, sigma_a, 2, [&](double phi) { return double(azimuthal_trt(section, sigma, phi, 0.2).x); });
                // Caustics are replaced by bells of only about their energy; least where the two nearly meet (1.9).
                CHECK(trt.around > 0.5 * trt.exact);
                CHECK(trt.around < 1.4 * trt.exact);
            }
}

TEST_CASE("TT leaves straight on and TRT shows its caustics where the cubic folds") {
    const CrossSection section = make_cross_section(1.55, 1);
    const float straight = azimuthal_tt(section, Rgb(0), kPiD).x;
    CHECK(straight > azimuthal_tt(section, Rgb(0), kPiD - 0.5).x);
    CHECK(azimuthal_tt(section, Rgb(0), 0.3).x == 0);  // TT turns by at most pi - 2 c = 1.74
    const double c = std::asin(1 / 1.55), a = 12 * c / kPiD - 2, b = 16 * c / (kPiD * kPiD * kPiD);
    const double fold = 2.0 / 3 * a * std::sqrt(a / (3 * b));
    const float peak = azimuthal_trt(section, Rgb(0), fold, 0.1).x;
    CHECK(peak == doctest::Approx(double(azimuthal_trt(section, Rgb(0), -fold, 0.1).x)).epsilon(1e-4));
    CHECK(peak > 1.5f * azimuthal_trt(section, Rgb(0), fold + 0.4, 0.1).x);
}

TEST_CASE("caustics are finite, at every index and on a fine grid of azimuths") {
    for (double eta = 1; eta < 3; eta += 0.05)
        for (const double width : {0.0175, 0.2}) {
            const CrossSection section = make_cross_section(eta, 1);
            for (int k = -2000; k <= 2000; ++k) {
                const double phi = kPiD * k / 2000;
                const float tt = azimuthal_tt(section, Rgb(0), phi).x;
                const float trt = azimuthal_trt(section, Rgb(0), phi, width).x;
                CAPTURE(eta);
                CAPTURE(phi);
                CHECK((tt >= 0 && tt <= 150));  // three roots at the floored slope of 0.01, whole energy
                CHECK((trt >= 0 && trt <= 150));
            }
        }
}

TEST_CASE("the energy that the far field scatters is finite and within its range") {
    // White light, no absorption. Less than 1: paths past TRT are left out, and wide lobes are cut at the poles.
    // More than 1: near grazing cos(theta_i) / cos^2(theta_d) outgrows the light that comes in: fourfold at a
    // lobe's peak, of which little is left after R's share and the lobe's width.
    for (const float beta_m : {0.0f, 0.1f, 0.3f, 0.6f, 1.0f}) {
        const Fiber fiber = fiber_of(beta_m, 0.3f, FiberModel::marschner);
        for (const double theta : {0.0, 0.5, 1.0, 1.3, 1.5}) {
            const Albedo albedo = albedo_of(fiber, Rgb(0), theta, 0, 0);
            const double energy = albedo.forward.x + albedo.reflected.x;
            MESSAGE("beta_m " << beta_m << ", theta " << theta << ": energy " << energy << ", of it TT "
                              << albedo.forward.x);
            CAPTURE(beta_m);
            CAPTURE(theta);
            CHECK(energy > 0.2);
            CHECK(energy < 1.1);
        }
    }
}

TEST_CASE("the far field does not read h") {
    const Fiber fiber = fiber_of(0.3f, 0.3f, FiberModel::marschner);
    const Vec3 wo = direction(0.2, 1), wi = direction(-0.1, -1.7);
    const FiberScattering a = evaluate(fiber, Rgb(0.2f), wo, wi, -1), b = evaluate(fiber, Rgb(0.2f), wo, wi, 0.4f);
    CHECK(a.forward == b.forward);
    CHECK(a.reflected == b.reflected);
}

TEST_CASE("near and far field look alike where lobes are narrow and many offsets are seen") {
    // Mean over h of the near field against the far field, as energies of the two parts at moderate inclination.
    for (const double theta : {0.0, 0.6}) {
        const Fiber far = fiber_of(0.1f, 0.3f, FiberModel::marschner), near = fiber_of(0.1f, 0.3f);
        const Albedo f = albedo_of(far, Rgb(0.3f), theta, 0, 0);
        glm::dvec3 forward(0), reflected(0);
        for (const QuadratureNode& gamma : gauss_legendre(12, -kPiD / 2, kPiD / 2)) {
            const Albedo n = albedo_of(near, Rgb(0.3f), theta, 0, std::sin(gamma.x));
            forward += gamma.weight * std::cos(gamma.x) / 2 * n.forward;
            reflected += gamma.weight * std::cos(gamma.x) / 2 * n.reflected;
        }
        CAPTURE(theta);
        // 5 %: Bravais against true Fresnel, theta_d against theta_o, the caustic's bells, the paths past TRT.
        CHECK(f.forward.x == doctest::Approx(forward.x).epsilon(0.05));
        CHECK(f.reflected.x == doctest::Approx(reflected.x).epsilon(0.15));
    }
}

TEST_CASE("the pdf of the far field integrates to one") {
    for (const float beta_m : {0.05f, 0.3f, 1.0f})
        for (const double theta : {0.0, -1.2, 1.5}) {
            const Fiber fiber = fiber_of(beta_m, 0.3f, FiberModel::marschner);
            const double sum = pdf_integral(fiber, Rgb(0.3f), theta, 0.3, 0);
            CAPTURE(beta_m);
            CAPTURE(theta);
            CHECK(std::abs(sum - 1) < 1e-3);
        }
}
