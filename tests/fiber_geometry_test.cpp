// SPDX-License-Identifier: MIT
// Sharp lobes leave where a ray traced through a glass cylinder does.
#include <doctest/doctest.h>

#include "tools/check/support/fiber_quadrature.h"

using namespace tress;

namespace {

constexpr double kEta = 1.55;

DVec3 reflected(const DVec3& d, const DVec3& normal) { return d - 2 * dot(d, normal) * normal; }

/// Snell's law for a ray against `normal`; eta: of where it comes from over where it goes.
DVec3 refracted(const DVec3& d, const DVec3& normal, double eta) {
    const double cos_i = -dot(d, normal);
    const double cos_t = std::sqrt(1 - eta * eta * (1 - cos_i * cos_i));
    return eta * d + (eta * cos_i - cos_t) * normal;
}

DVec3 normal_at(const DVec3& p) { return normalize(DVec3(0, p.y, p.z)); }

/// The other end of the chord from p along d, inside the unit cylinder about x.
DVec3 far_wall(const DVec3& p, const DVec3& d) { return p - 2 * (p.y * d.y + p.z * d.z) / (d.y * d.y + d.z * d.z) * d; }

/// Where the light seen along wo at offset h comes from: after `chords` crossings of the inside.
DVec3 traced(const DVec3& wo, double h, int chords) {
    const DVec3 across = normalize(cross(DVec3(1, 0, 0), wo));  // as core/fiber.h says where h lies
    const DVec3 toward = normalize(DVec3(0, wo.y, wo.z));
    DVec3 p = h * across + std::sqrt(1 - h * h) * toward;
    if (chords == 0) return reflected(-wo, normal_at(p));
    DVec3 d = refracted(-wo, normal_at(p), 1 / kEta);
    p = far_wall(p, d);
    for (int chord = 1; chord < chords; ++chord) {
        d = reflected(d, normal_at(p));
        p = far_wall(p, d);
    }
    return refracted(d, -normal_at(p), kEta);
}

Fiber sharp_fiber() {
    FiberParameters parameters;
    parameters.beta_m = 0.01f;
    parameters.beta_n = 0.01f;
    parameters.alpha_degrees = 0;
    parameters.eta = float(kEta);
    return make_fiber(parameters);
}

float value_at(const Fiber& fiber, const DVec3& wo, double theta, double phi, double h, int chords) {
    const FiberScattering value = evaluate(fiber, Rgb(0), Vec3(wo), direction(theta, phi), float(h));
    return chords == 1 ? value.forward.x : value.reflected.x;
}

}  // namespace

TEST_CASE("R, TT and TRT leave where mirrors and Snell's law send them") {
    const Fiber fiber = sharp_fiber();
    // Two scales to either side of a peak the lobe is a third as high. Equal heights to 2 % place the peak within
    // 1 % of a scale (1.7e-3 radians), of which rounding of the directions is a hundredth. At these offsets the
    // lobes do not overlap.
    for (const int chords : {0, 1, 2})
        for (const double h : {-0.85, -0.35, 0.25, 0.6})
            for (const double theta : {0.0, 0.5, -1.1})
                for (const double phi : {kPiD / 2, 0.3, -2.8}) {
                    CAPTURE(chords);
                    CAPTURE(h);
                    CAPTURE(theta);
                    CAPTURE(phi);
                    const DVec3 wo(std::sin(theta), std::cos(theta) * std::cos(phi), std::cos(theta) * std::sin(phi));
                    const DVec3 wi = traced(wo, h, chords);
                    const double phi_i = std::atan2(wi.z, wi.y), theta_i = std::asin(wi.x);
                    CHECK(theta_i == doctest::Approx(-theta));
                    const double step = 2 * double(fiber.azimuthal.scale);
                    const float peak = value_at(fiber, wo, theta_i, phi_i, h, chords);
                    const float left = value_at(fiber, wo, theta_i, phi_i - step, h, chords);
                    const float right = value_at(fiber, wo, theta_i, phi_i + step, h, chords);
                    CHECK(left == doctest::Approx(double(right)).epsilon(0.02));
                    CHECK(peak > 2 * left);
                }
}

TEST_CASE("scales turn R to the root, and TT and TRT to the tip, by 2, 1 and 4 tilts") {
    FiberParameters parameters;
    parameters.beta_m = 0.02f;
    parameters.alpha_degrees = 3;
    const Fiber fiber = make_fiber(parameters);
    const double alpha = 3 * kPiD / 180, shift[] = {-2 * alpha, alpha, 4 * alpha};
    const double theta_o = 0.4, h = 0.3;
    const DVec3 wo(std::sin(theta_o), 0, std::cos(theta_o));
    for (const int chords : {0, 1, 2}) {
        CAPTURE(chords);
        const DVec3 exit = traced(wo, h, chords);
        const double phi_i = std::atan2(exit.z, exit.y);
        const double width = std::sqrt(double(fiber.longitudinal[chords].variance));
        const float peak = value_at(fiber, wo, shift[chords] - theta_o, phi_i, h, chords);
        CHECK(peak > value_at(fiber, wo, shift[chords] - theta_o - width, phi_i, h, chords));
        CHECK(peak > value_at(fiber, wo, shift[chords] - theta_o + width, phi_i, h, chords));
    }
}
