// SPDX-License-Identifier: MIT
#include "core/fiber_chiang.h"

#include <numbers>

#include "core/fresnel.h"
#include "core/lobe_energy.h"

namespace tress {
namespace {

constexpr int kLobes = Fiber::kLobes;
constexpr int kDirected = kLobes - 1;  // lobes with an azimuth of their own
constexpr float kAllRound = 0.5f * kInvPi;

/// M_p N_p of every lobe.
struct Lobes {
    float density[kLobes];
};

Lobes lobe_densities(const Fiber& fiber, const ChiangPoint& point, const Vec3& wi) {
    const SinCos inclination = inclination_of(wi);
    const float phi = std::atan2(wi.z, wi.y);
    Lobes lobes;
    for (int p = 0; p < kLobes; ++p) {
        const float m = longitudinal(fiber.longitudinal[p], inclination, point.inclination[p]);
        const float n = p < kDirected ? azimuthal(fiber.azimuthal, wrap_angle(phi - point.azimuth[p])) : kAllRound;
        lobes.density[p] = m * n;
    }
    return lobes;
}

FiberScattering sum_lobes(const ChiangPoint& point, const Lobes& lobes) {
    FiberScattering value;
    for (int p = 0; p < kLobes; ++p) {
        Rgb& part = p == Fiber::kTransmitted ? value.forward : value.reflected;
        part += lobes.density[p] * point.energy[p];
    }
    return value;
}

/// Into [-pi, pi] by whole turns.
double folded(double angle) {
    constexpr double kTurn = 2 * std::numbers::pi;
    return angle - kTurn * std::floor(angle / kTurn + 0.5);
}

}  // namespace

ChiangPoint make_chiang_point(const Fiber& fiber, const Rgb& sigma_a, const Vec3& wo, float h) {
    ChiangPoint point;
    const SinCos inclination = inclination_of(wo);
    for (int p = 0; p < kLobes; ++p) point.inclination[p] = tilted(inclination, fiber.tilt[p]);

    const double offset = glm::clamp(double(h), -1.0, 1.0);
    const double cos_theta = glm::min(double(inclination.cos), 1.0);
    const double eta = double(fiber.parameters.eta);
    const Inclination inside = refract_inclination(eta, cos_theta);
    const double sin_gamma_t = offset / inside.bravais;

    // The ray turns by gamma_o at both ends and by pi - 2 gamma_t along every chord inside.
    const double gamma_o = std::asin(offset), gamma_t = std::asin(sin_gamma_t);
    const double phi_o = std::atan2(double(wo.z), double(wo.y));
    for (int p = 0; p < kDirected; ++p) {
        const double turn = 2 * gamma_o + p * (std::numbers::pi - 2 * gamma_t);
        point.azimuth[p] = float(folded(phi_o + turn));
    }

    const double reflectance = fresnel(eta, cos_theta * safe_sqrt(1 - offset * offset));
    const double length = chord_length(sin_gamma_t, inside.cos_t);
    for (int channel = 0; channel < 3; ++channel) {
        const LobeEnergy energy = lobe_energy(reflectance, transmitted(double(sigma_a[channel]), length));
        for (int p = 0; p < kLobes; ++p) point.energy[p][channel] = float(energy.of[p]);
    }
    share_lobes(point.energy, point.share);
    return point;
}

FiberScattering evaluate(const Fiber& fiber, const ChiangPoint& point, const Vec3& wi) {
    return sum_lobes(point, lobe_densities(fiber, point, wi));
}

FiberSample evaluate_with_pdf(const Fiber& fiber, const ChiangPoint& point, const Vec3& wi) {
    const Lobes lobes = lobe_densities(fiber, point, wi);
    float pdf = 0;
    for (int p = 0; p < kLobes; ++p) pdf += point.share[p] * lobes.density[p];
    return {wi, pdf, sum_lobes(point, lobes)};
}

Vec3 sample(const Fiber& fiber, const ChiangPoint& point, const glm::vec4& u) {
    const int p = choose_lobe(point.share, u.x);
    const float phi = p < kDirected ? point.azimuth[p] + sample_azimuthal(fiber.azimuthal, u.y) : kPi * (2 * u.y - 1);
    const SinCos theta = sample_longitudinal(fiber.longitudinal[p], point.inclination[p], u.z, u.w);
    return {theta.sin, theta.cos * std::cos(phi), theta.cos * std::sin(phi)};
}

}  // namespace tress
