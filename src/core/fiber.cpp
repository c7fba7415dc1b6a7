// SPDX-License-Identifier: MIT
#include "core/fiber.h"

#include <cassert>
#include <numbers>

#include "core/error.h"
#include "core/fiber_chiang.h"
#include "core/fiber_marschner.h"
#include "core/shortest_text.h"

namespace tress {
namespace {

void check(const char* name, float value, float lowest, float highest) {
    if (value >= lowest && value <= highest) return;
    throw InputError(std::string("fiber.") + name, shortest_text(value) + ", expected a number from " +
                                                       shortest_text(lowest) + " to " + shortest_text(highest));
}

/// Longitudinal variance of R (Chiang et al. 2016).
double variance_of(double beta_m) {
    return square(0.726 * beta_m + 0.812 * beta_m * beta_m + 3.7 * std::pow(beta_m, 20));
}

/// Scale of the logistic (Chiang et al. 2016; sqrt(pi / 8) turns a Gaussian's width into a logistic's).
double scale_of(double beta_n) {
    return std::sqrt(std::numbers::pi / 8) * (0.265 * beta_n + 1.194 * beta_n * beta_n + 5.372 * std::pow(beta_n, 22));
}

/// Calls `function` with the fiber as seen from wo at h, whichever its model.
template <class Function>
auto with_point(const Fiber& fiber, const Rgb& sigma_a, const Vec3& wo, float h, const Function& function) {
    if (fiber.parameters.model == FiberModel::marschner) return function(make_marschner_point(fiber, sigma_a, wo));
    return function(make_chiang_point(fiber, sigma_a, wo, h));
}

/// Leaves the lobes that are not asked for out of what is sampled.
template <class Point>
void keep_lobes(Point& point, FiberLobes lobes) {
    if (lobes == FiberLobes::all) return;
    point.share[Fiber::kTransmitted] = 0;
    float sum = 0;
    for (const float share : point.share) sum += share;
    for (float& share : point.share) share = sum > 0 ? share / sum : 0;
}

FiberSample without_others(FiberSample sample, FiberLobes lobes) {
    if (lobes == FiberLobes::reflected) sample.value.forward = Rgb(0);
    return sample;
}

}  // namespace

Fiber make_fiber(const FiberParameters& parameters) {
    check("beta_m", parameters.beta_m, 0, 1);
    check("beta_n", parameters.beta_n, 0, 1);
    check("alpha", parameters.alpha_degrees, -45, 45);
    check("eta", parameters.eta, 1, 10);
    for (int channel = 0; channel < 3; ++channel) check("sigma_a", parameters.sigma_a[channel], 0, kInfinity);

    // TT is half and TRT twice as wide as R (Marschner et al. 2003, table 1); the rest is as TRT.
    constexpr double kWidening[Fiber::kLobes] = {1, 0.25, 4, 4};
    // Of theta_i + theta_o in tilts. Scales open to the tip, so that R turns to the root.
    constexpr double kNearShift[Fiber::kLobes] = {-2, 1, 4, 0};  // d'Eon et al. 2011
    constexpr double kFarShift[Fiber::kLobes] = {-2, 1, 3, 0};   // Marschner et al. 2003, table 1, doubled: theta_h
    const bool near_field = parameters.model == FiberModel::chiang;

    Fiber fiber;
    fiber.parameters = parameters;
    fiber.azimuthal = make_azimuthal(scale_of(double(parameters.beta_n)));
    const double alpha = double(parameters.alpha_degrees) * std::numbers::pi / 180;
    for (int p = 0; p < Fiber::kLobes; ++p) {
        const double shift = (near_field ? kNearShift[p] : kFarShift[p]) * alpha;
        fiber.longitudinal[p] = make_longitudinal(kWidening[p] * variance_of(double(parameters.beta_m)));
        fiber.shift[p] = float(shift);
        fiber.tilt[p] = {float(std::sin(shift)), float(std::cos(shift))};
    }
    return fiber;
}

FiberScattering evaluate(const Fiber& fiber, const Rgb& sigma_a, const Vec3& wo, const Vec3& wi, float h) {
    return with_point(fiber, sigma_a, wo, h, [&](const auto& point) { return evaluate(fiber, point, wi); });
}

void evaluate(const Fiber& fiber, const Rgb& sigma_a, const Vec3& wo, float h, std::span<const Vec3> wi,
              std::span<FiberScattering> value) {
    assert(wi.size() == value.size());
    with_point(fiber, sigma_a, wo, h, [&](const auto& point) {
        for (size_t i = 0; i < wi.size(); ++i) value[i] = evaluate(fiber, point, wi[i]);
    });
}

FiberSample evaluate_with_pdf(const Fiber& fiber, const Rgb& sigma_a, const Vec3& wo, const Vec3& wi, float h,
                              FiberLobes lobes) {
    return with_point(fiber, sigma_a, wo, h, [&](auto point) {
        keep_lobes(point, lobes);
        return without_others(evaluate_with_pdf(fiber, point, wi), lobes);
    });
}

FiberSample sample(const Fiber& fiber, const Rgb& sigma_a, const Vec3& wo, float h, const glm::vec4& u,
                   FiberLobes lobes) {
    FiberSample drawn;
    sample(fiber, sigma_a, wo, h, {&u, 1}, {&drawn, 1}, lobes);
    return drawn;
}

void sample(const Fiber& fiber, const Rgb& sigma_a, const Vec3& wo, float h, std::span<const glm::vec4> u,
            std::span<FiberSample> drawn, FiberLobes lobes) {
    assert(u.size() == drawn.size());
    with_point(fiber, sigma_a, wo, h, [&](auto point) {
        keep_lobes(point, lobes);
        for (size_t i = 0; i < drawn.size(); ++i)
            drawn[i] = without_others(evaluate_with_pdf(fiber, point, sample(fiber, point, u[i])), lobes);
    });
}

float pdf(const Fiber& fiber, const Rgb& sigma_a, const Vec3& wo, const Vec3& wi, float h) {
    return evaluate_with_pdf(fiber, sigma_a, wo, wi, h).pdf;
}

}  // namespace tress
