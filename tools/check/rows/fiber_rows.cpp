// SPDX-License-Identifier: MIT
#include "tools/check/rows/fiber_limit_rows.h"
#include "tools/check/support/fiber_reciprocity.h"
#include "tools/number_text.h"

namespace tress {
namespace {

/// Of wo, from along the normal to along the fiber, and from the middle to the very rim.
struct Seen {
    double theta, h;
};
constexpr Seen kSeen[] = {{0, 0}, {0.4, -0.4}, {-0.8, 0.8}, {1.2, 0.99}, {1.5, 1}, {kPiD / 2, -1}};

/// Greatest |albedo - 1| of a fiber that does not absorb.
double furnace_error(const Fiber& fiber) {
    double worst = 0;
    for (const Seen& seen : kSeen)
        worst = std::max(worst, std::abs(albedo_of(fiber, Rgb(0), seen.theta, 0.4, seen.h).sum() - 1));
    return worst;
}

Outcome near_specular(const CheckSettings&) {
    constexpr double kLeastVariance = double(1e-6f), kTolerance = 1e-3;
    Outcome outcome;
    const Fiber smoothest = fiber_of(0, 0);
    double least = 1, far_least = 1, far_greatest = 0;
    for (const LongitudinalLobe& lobe : smoothest.longitudinal) least = std::min(least, double(lobe.variance));
    outcome.figures.push_back(at_least("smallest variance of a lobe at beta_m = 0", least, kLeastVariance));
    for (const float beta : {0.0f, 1e-3f, 0.01f, 0.1f, 1.0f}) {
        const double error = std::max(furnace_error(fiber_of(beta, beta)), furnace_error(fiber_of(beta, 0.3f)));
        const std::string at = significant(double(beta), 1);
        outcome.figures.push_back(
            at_most("largest |albedo - 1| at beta = " + at + ", 12 white furnaces", error, kTolerance));
        for (const double theta : {0.0, 1.2}) {
            const Fiber far_field = fiber_of(beta, 0.3f, FiberModel::marschner);
            const double energy = albedo_of(far_field, Rgb(0), theta, 0, 0).sum();
            far_least = std::min(far_least, energy), far_greatest = std::max(far_greatest, energy);
        }
    }
    outcome.figures.push_back(told("least albedo of the far field model, which does not keep energy", far_least));
    outcome.figures.push_back(told("greatest albedo of the far field model", far_greatest));
    return outcome;
}

/// I0(x) exp(-x) in double: what the library has, or where that overflows an asymptotic series that has converged by
/// then (Abramowitz & Stegun 1964, 9.7.1).
double scaled_bessel(double x) {
    if (x < 500) return std::cyl_bessel_i(0.0, x) * std::exp(-x);
    double term = 1, sum = 1;
    for (int k = 1; k < 8; ++k) sum += term *= square(2 * k - 1.0) / (8 * k * x);
    return sum / std::sqrt(2 * kPiD * x);
}

double bessel_error() {
    constexpr int kSteps = 200'000;
    double worst = 0;
    for (int k = 0; k <= kSteps; ++k) {
        const float x = float(std::pow(10, -3 + 9.0 * k / kSteps));  // to 1e6, as cos cos / v reaches
        const ScaledBessel b = scaled_bessel_i0(x);
        const double value = double(b.factor) * std::exp(double(b.exponent)), exact = scaled_bessel(double(x));
        worst = std::max(worst, std::abs(value / exact - 1));
    }
    return worst;
}

/// Greatest variance at which the formula as published, in single precision, says that nothing is reflected at its very
/// peak, or says no number.
double direct_form_breaks_at() {
    const auto breaks = [](float v) {
        const float x = 1 / v, bessel = float(std::cyl_bessel_i(0.0, double(x)));
        const float value = bessel / (2 * v * std::sinh(x));
        return !(value > 0 && std::isfinite(value));
    };
    float v = 1;
    while (!breaks(v)) v *= 0.9999f;
    return double(v);
}

Outcome bessel_functions(const CheckSettings&) {
    constexpr double kTolerance = 1e-5;
    constexpr int kVariances = 121;
    double worst = 0;
    for (int k = 0; k < kVariances; ++k)
        for (const double theta : {0.0, 0.3, -0.9, 1.2, 1.4, -1.5, 1.57, kPiD / 2, -kPiD / 2}) {
            const double variance = std::pow(10, -6.0 * k / (kVariances - 1));
            worst = std::max(worst, std::abs(longitudinal_integral(make_longitudinal(variance), theta) - 1));
        }
    return {
        {at_most("largest |integral of M cos - 1|, 121 variances from 1e-6 to 1 by 9 inclinations", worst, kTolerance),
         at_most("largest error of log(I0(x) exp(-x)), 2e5 x from 0.001 to 1e6", bessel_error(), kTolerance),
         told("the formula as published breaks in single precision below the variance", direct_form_breaks_at())},
        {}};
}

double pdf_error(const Fiber& fiber, double theta, double h) {
    double worst = 0;
    for (const FiberLobes lobes : {FiberLobes::all, FiberLobes::reflected})
        worst = std::max(worst, std::abs(pdf_integral(fiber, Rgb(0.1f, 0.4f, 1.5f), theta, 0.3, h, lobes) - 1));
    return worst;
}

Outcome reciprocity_and_pdf(const CheckSettings&) {
    constexpr double kTolerance = 1e-3, kDocumented = 0.08;  // core/fiber.h
    constexpr uint64_t kPairs = 4000;
    double near_pdf = 0, far_pdf = 0;
    for (const float beta_m : {0.0f, 0.1f, 0.3f, 1.0f})
        for (const Seen& seen : {Seen{0.7, 0}, {-1.2, -0.6}, {1.5, 1}})
            near_pdf = std::max(near_pdf, pdf_error(fiber_of(beta_m, 0.3f), seen.theta, seen.h));
    for (const float beta_m : {0.05f, 0.3f, 1.0f})
        far_pdf = std::max(far_pdf, pdf_error(fiber_of(beta_m, 0.3f, FiberModel::marschner), -1.2, 0));
    const Reciprocity near_field = near_field_reciprocity(kPairs);
    const Asymmetry far_field = far_field_reciprocity(kPairs);
    return {{at_most("asymmetry of f |cos| at an index of 1, largest of 4000 pairs", near_field.glassless.largest,
                     kTolerance),
             at_most("asymmetry between opposite inclinations, averaged over h, largest of 4000 pairs",
                     near_field.opposite.largest, kTolerance),
             at_most("asymmetry between any directions, averaged over h, mean of 4000 pairs", near_field.any.of_sums,
                     kDocumented),
             at_most("asymmetry of the far field model's f, largest of 4000 pairs", far_field.largest, kTolerance),
             at_most("largest |integral of the pdf - 1|, 24 integrals", near_pdf, kTolerance),
             at_most("largest |integral of the pdf - 1| of the far field model, 6 integrals", far_pdf, kTolerance)},
            {}};
}

}  // namespace

std::vector<CheckRow> fiber_rows() {
    std::vector<CheckRow> rows = {
        {"D26", "Near specular fiber: roughness beta to 0", "Variance kept at 1e-6 and above, no energy lost.",
         near_specular},
        {"D27", "Bessel function I0 and sinh of large arguments",
         "Energy of the longitudinal lobe kept at every variance from 1e-6 to 1.", bessel_functions},
        {"D31", "Reciprocity and pdf",
         "f |cos| the same with the light reversed where the model says so, elsewhere within what core/fiber.h states; "
         "the pdf integrates to 1.",
         reciprocity_and_pdf}};
    const std::vector<CheckRow> limits = fiber_limit_rows();
    rows.insert(rows.end(), limits.begin(), limits.end());
    return rows;
}

}  // namespace tress
