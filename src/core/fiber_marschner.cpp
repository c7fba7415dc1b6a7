// SPDX-License-Identifier: MIT
#include "core/fiber_marschner.h"

#include <algorithm>
#include <numbers>

#include "core/fresnel.h"
#include "core/lobe_energy.h"
#include "core/marschner_azimuthal.h"

namespace tress {
namespace {

enum Lobe { kR, kTT, kTRT };
constexpr int kDirected = 3;

/// Scale of the logistic that stands for TT when sampling: near its width at an index of 1.55.
constexpr double kForwardScale = 0.5;
const AzimuthalLobe kForward = make_azimuthal(kForwardScale);

/// Width of the caustic's blur: the deviation of the near field's logistic, kept to the paper's 10 to 25 degrees
/// above and to a degree below, where it would show as noise.
constexpr double kNarrowestCaustic = std::numbers::pi / 180;
constexpr double kWidestCaustic = 25 * std::numbers::pi / 180;

double caustic_width(const Fiber& fiber) {
    const double deviation = double(fiber.azimuthal.scale) * std::numbers::pi / std::sqrt(3.0);
    return std::clamp(deviation, kNarrowestCaustic, kWidestCaustic);
}

/// Density with which `sample` chooses the azimuth of lobe p.
float azimuth_density(int p, float phi) {
    if (p == kR) return 0.25f * std::abs(std::cos(0.5f * phi));
    if (p == kTT) return azimuthal(kForward, wrap_angle(phi - kPi));
    return 0.5f * kInvPi;
}

float sample_azimuth(int p, float u) {
    if (p == kR) return 2 * safe_asin(2 * u - 1);
    if (p == kTT) return kPi + sample_azimuthal(kForward, u);
    return kPi * (2 * u - 1);
}

/// A rough mean over h of the energy of each lobe, for choosing among them.
void estimate_shares(const Fiber& fiber, MarschnerPoint& point) {
    constexpr double kOffset[] = {0.25, 0.75, 0.95};
    constexpr float kWeight[] = {0.5f, 0.4f, 0.1f};
    const double cosine = std::cos(double(point.theta));
    const CrossSection section = make_cross_section(double(fiber.parameters.eta), cosine);
    Rgb energy[Fiber::kLobes]{};
    for (int i = 0; i < 3; ++i) {
        const double h = kOffset[i];
        const double f = reflectance(section, h, safe_sqrt(1 - h * h));
        for (int channel = 0; channel < 3; ++channel) {
            const double t = transmitted(double(point.sigma_a[channel]), path_length(section, h));
            const LobeEnergy at = lobe_energy(f, t);
            for (int p = 0; p < kDirected; ++p) energy[p][channel] += kWeight[i] * float(at.of[p]);
        }
    }
    share_lobes(energy, point.share);
}

}  // namespace

double marschner_cos_theta_d(double theta_i, double theta_o) {
    constexpr double kLeast = 1e-3;
    return std::max(std::cos(0.5 * (theta_i - theta_o)), kLeast);
}

double marschner_longitudinal(const Fiber& fiber, int lobe, double theta_i, double theta_o) {
    const double variance = double(fiber.longitudinal[lobe].variance);
    const double x = theta_i + theta_o - double(fiber.shift[lobe]);
    const double bell = std::exp(-0.5 * x * x / variance) / std::sqrt(2 * std::numbers::pi * variance);
    return bell * std::cos(theta_i) / square(marschner_cos_theta_d(theta_i, theta_o));
}

MarschnerPoint make_marschner_point(const Fiber& fiber, const Rgb& sigma_a, const Vec3& wo) {
    MarschnerPoint point;
    const SinCos o = inclination_of(wo);
    for (int p = 0; p < Fiber::kLobes; ++p) point.inclination[p] = tilted(o, fiber.tilt[p]);
    point.theta = std::atan2(o.sin, o.cos);
    point.phi = std::atan2(wo.z, wo.y);
    point.sigma_a = sigma_a;
    estimate_shares(fiber, point);
    return point;
}

FiberScattering evaluate(const Fiber& fiber, const MarschnerPoint& point, const Vec3& wi) {
    const SinCos i = inclination_of(wi);
    const double theta_i = std::atan2(double(i.sin), double(i.cos)), theta_o = double(point.theta);
    const double phi = double(wrap_angle(std::atan2(wi.z, wi.y) - point.phi));
    const CrossSection section =
        make_cross_section(double(fiber.parameters.eta), marschner_cos_theta_d(theta_i, theta_o));

    float m[kDirected];
    for (int p = 0; p < kDirected; ++p) m[p] = float(std::max(marschner_longitudinal(fiber, p, theta_i, theta_o), 0.0));
    FiberScattering value;
    if (m[kR] > 0) value.reflected = Rgb(m[kR] * float(azimuthal_r(section, phi)));
    if (m[kTT] > 0) value.forward = m[kTT] * azimuthal_tt(section, point.sigma_a, phi);
    if (m[kTRT] > 0) value.reflected += m[kTRT] * azimuthal_trt(section, point.sigma_a, phi, caustic_width(fiber));
    return value;
}

FiberSample evaluate_with_pdf(const Fiber& fiber, const MarschnerPoint& point, const Vec3& wi) {
    const SinCos i = inclination_of(wi);
    const float phi = wrap_angle(std::atan2(wi.z, wi.y) - point.phi);
    float pdf = 0;
    for (int p = 0; p < kDirected; ++p)
        pdf += point.share[p] * longitudinal(fiber.longitudinal[p], i, point.inclination[p]) * azimuth_density(p, phi);
    return {wi, pdf, evaluate(fiber, point, wi)};
}

Vec3 sample(const Fiber& fiber, const MarschnerPoint& point, const glm::vec4& u) {
    const int p = std::min(choose_lobe(point.share, u.x), kDirected - 1);
    const float phi = point.phi + sample_azimuth(p, u.y);
    const SinCos theta = sample_longitudinal(fiber.longitudinal[p], point.inclination[p], u.z, u.w);
    return {theta.sin, theta.cos * std::cos(phi), theta.cos * std::sin(phi)};
}

}  // namespace tress
