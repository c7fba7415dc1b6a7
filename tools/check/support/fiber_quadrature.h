// SPDX-License-Identifier: MIT
// Directions, and what a fiber scatters of them in all, by quadrature that resolves lobes of any width.
#pragma once

#include <algorithm>
#include <numbers>
#include <vector>

#include "core/fiber.h"
#include "core/gauss_legendre.h"
#include "core/rng.h"

namespace tress {

inline constexpr double kPiD = std::numbers::pi;

inline Vec3 direction(double theta, double phi) {
    return Vec3(DVec3(std::sin(theta), std::cos(theta) * std::cos(phi), std::cos(theta) * std::sin(phi)));
}

inline SinCos sin_cos(double theta) { return {float(std::sin(theta)), float(std::max(std::cos(theta), 0.0))}; }

inline Fiber fiber_of(float beta_m, float beta_n, FiberModel model = FiberModel::chiang) {
    FiberParameters parameters;
    parameters.model = model;
    parameters.beta_m = beta_m;
    parameters.beta_n = beta_n;
    return make_fiber(parameters);
}

inline Vec3 uniform_direction(uint64_t key) {
    const double z = 2 * double(random(key, 0)) - 1;
    return direction(std::asin(z), 2 * kPiD * double(random(key, 1)));
}

/// Nodes on [lo, hi] in panels that double in width away from each peak, the first `width` wide: with six nodes a
/// panel, a lobe of that width or more is integrated to about 1e-5 of its energy.
inline std::vector<QuadratureNode> graded_nodes(double lo, double hi, const std::vector<double>& peaks, double width) {
    constexpr int kNodes = 6;
    std::vector<double> edges{lo, hi};
    for (const double peak : peaks) {
        edges.push_back(std::clamp(peak, lo, hi));
        for (double step = width; step < 2 * (hi - lo); step *= 2) {
            edges.push_back(std::clamp(peak - step, lo, hi));
            edges.push_back(std::clamp(peak + step, lo, hi));
        }
    }
    std::sort(edges.begin(), edges.end());
    std::vector<QuadratureNode> nodes;
    for (size_t i = 0; i + 1 < edges.size(); ++i) {
        if (!(edges[i + 1] > edges[i])) continue;
        const std::vector<QuadratureNode> panel = gauss_legendre(kNodes, edges[i], edges[i + 1]);
        nodes.insert(nodes.end(), panel.begin(), panel.end());
    }
    return nodes;
}

/// Directions and weights that integrate over the sphere a fiber's scattering from wo = direction(theta_o, phi_o) at h.
struct SphereNodes {
    std::vector<Vec3> direction;
    std::vector<double> weight;
};

inline SphereNodes sphere_nodes(const Fiber& fiber, double theta_o, double phi_o, double h) {
    const double eta = double(fiber.parameters.eta);
    const double cosine = std::max(std::cos(theta_o), 1e-9);
    const double bravais = std::sqrt(cosine * cosine + (eta * eta - 1)) / cosine;
    std::vector<double> azimuths, inclinations;
    for (int p = 0; p < 3; ++p) {
        const double turn = 2 * std::asin(h) + p * (kPiD - 2 * std::asin(h / bravais));
        const double azimuth = std::remainder(phi_o + turn, 2 * kPiD);
        for (const double whole_turn : {-2 * kPiD, 0.0, 2 * kPiD})
            if (std::abs(azimuth + whole_turn) < 1.5 * kPiD) azimuths.push_back(azimuth + whole_turn);
    }
    for (const float shift : fiber.shift)
        inclinations.push_back(std::asin(std::sin(double(shift) - theta_o)));  // folded at the poles
    const double width = std::sqrt(double(fiber.longitudinal[Fiber::kTransmitted].variance));
    const auto thetas = graded_nodes(-kPiD / 2, kPiD / 2, inclinations, std::min(width, 0.5));
    const auto phis = graded_nodes(-kPiD, kPiD, azimuths, std::min(2 * double(fiber.azimuthal.scale), 0.5));
    SphereNodes nodes;
    for (const QuadratureNode& theta : thetas)
        for (const QuadratureNode& phi : phis) {
            nodes.direction.push_back(direction(theta.x, phi.x));
            nodes.weight.push_back(theta.weight * phi.weight * std::cos(theta.x));
        }
    return nodes;
}

/// Integral of M cos(theta_i): 1 to 1e-5, of which the Bessel function's 5e-7, rounding of the inclinations (6e-8 of a
/// width of 1e-3), and the quadrature.
inline double longitudinal_integral(const LongitudinalLobe& lobe, double theta_o) {
    const double width = std::min(std::sqrt(double(lobe.variance)), 0.5);
    double sum = 0;
    for (const QuadratureNode& theta : graded_nodes(-kPiD / 2, kPiD / 2, {-theta_o}, 0.5 * width))
        sum += theta.weight * std::cos(theta.x) * double(longitudinal(lobe, sin_cos(theta.x), sin_cos(theta_o)));
    return sum;
}

/// Integral of the density with which directions are drawn for wo = direction(theta_o, phi_o).
inline double pdf_integral(const Fiber& fiber, const Rgb& sigma_a, double theta_o, double phi_o, double h,
                           FiberLobes lobes = FiberLobes::all) {
    const SphereNodes nodes = sphere_nodes(fiber, theta_o, phi_o, h);
    const Vec3 wo = direction(theta_o, phi_o);
    double sum = 0;
    for (size_t i = 0; i < nodes.direction.size(); ++i)
        sum += nodes.weight[i] * double(evaluate_with_pdf(fiber, sigma_a, wo, nodes.direction[i], float(h), lobes).pdf);
    return sum;
}

/// Albedo of both parts, by quadrature.
struct Albedo {
    glm::dvec3 forward{0}, reflected{0};

    /// Of red.
    double sum() const { return forward.x + reflected.x; }
};

/// What a cylinder of glass reflects at its first wall: Fresnel's equations with Snell's law, nothing rearranged.
inline double first_reflectance(double eta, double theta, double h) {
    const double cos_i = std::cos(theta) * std::sqrt(1 - h * h);
    const double cos_t = std::sqrt(1 - (1 - cos_i * cos_i) / square(eta));
    return 0.5 * (square((cos_i - eta * cos_t) / (cos_i + eta * cos_t)) +
                  square((eta * cos_i - cos_t) / (eta * cos_i + cos_t)));
}

inline Albedo albedo_of(const Fiber& fiber, const Rgb& sigma_a, double theta_o, double phi_o, double h) {
    const SphereNodes nodes = sphere_nodes(fiber, theta_o, phi_o, h);
    std::vector<FiberScattering> value(nodes.direction.size());
    evaluate(fiber, sigma_a, direction(theta_o, phi_o), float(h), nodes.direction, value);
    Albedo albedo;
    for (size_t i = 0; i < value.size(); ++i) {
        albedo.forward += nodes.weight[i] * glm::dvec3(value[i].forward);
        albedo.reflected += nodes.weight[i] * glm::dvec3(value[i].reflected);
    }
    return albedo;
}

}  // namespace tress
