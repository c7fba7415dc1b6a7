// SPDX-License-Identifier: MIT
#include "core/forward_albedo.h"

#include <algorithm>
#include <numbers>

#include "core/fiber_marschner.h"
#include "core/fresnel.h"
#include "core/gauss_legendre.h"
#include "core/marschner_azimuthal.h"

namespace tress {
namespace {

constexpr int kOffsets = 32;       // over gamma in [0, pi / 2], h = sin(gamma): smooth in gamma, not in h
constexpr int kInclinations = 32;  // of wi
constexpr double kReach = 7;       // standard deviations of the Gaussian that are integrated

const std::vector<QuadratureNode>& offsets() {
    static const std::vector<QuadratureNode> nodes = gauss_legendre(kOffsets, 0, std::numbers::pi / 2);
    return nodes;
}

ForwardPaths chiang_paths(const Fiber& fiber, double sin_theta) {
    ForwardPaths paths;
    const double eta = double(fiber.parameters.eta);
    const double cos_theta = safe_sqrt(1 - sin_theta * sin_theta);
    const Inclination inside = refract_inclination(eta, cos_theta);
    for (const QuadratureNode& gamma : offsets()) {
        const double h = std::sin(gamma.x), dh = std::cos(gamma.x) * gamma.weight;
        paths.weight.push_back(dh * square(1 - fresnel(eta, cos_theta * std::cos(gamma.x))));
        paths.length.push_back(chord_length(h / inside.bravais, inside.cos_t));
    }
    return paths;
}

/// Over the inclinations of wi as well: theta_d, and with it the cross-section, differs along the lobe.
ForwardPaths marschner_paths(const Fiber& fiber, double sin_theta) {
    ForwardPaths paths;
    const std::vector<QuadratureNode>& gammas = offsets();
    const double theta_o = std::asin(std::clamp(sin_theta, -1.0, 1.0));
    const double middle = double(fiber.shift[Fiber::kTransmitted]) - theta_o;
    const double reach = kReach * std::sqrt(double(fiber.longitudinal[Fiber::kTransmitted].variance));
    const double lo = std::max(middle - reach, -std::numbers::pi / 2);
    const double hi = std::min(middle + reach, std::numbers::pi / 2);
    if (!(lo < hi)) return paths;
    for (const QuadratureNode& theta : gauss_legendre(kInclinations, lo, hi)) {
        const double along = marschner_longitudinal(fiber, Fiber::kTransmitted, theta.x, theta_o) * std::cos(theta.x);
        const CrossSection section =
            make_cross_section(double(fiber.parameters.eta), marschner_cos_theta_d(theta.x, theta_o));
        for (const QuadratureNode& gamma : gammas) {
            const double h = std::sin(gamma.x), dh = std::cos(gamma.x) * gamma.weight;
            const double entered = square(1 - reflectance(section, h, std::cos(gamma.x)));
            paths.weight.push_back(theta.weight * along * dh * entered);
            paths.length.push_back(path_length(section, h));
        }
    }
    return paths;
}

}  // namespace

ForwardPaths forward_paths(const Fiber& fiber, double sin_theta) {
    return fiber.parameters.model == FiberModel::chiang ? chiang_paths(fiber, sin_theta)
                                                        : marschner_paths(fiber, sin_theta);
}

double albedo(const ForwardPaths& paths, double sigma_a) {
    double sum = 0;
    for (size_t i = 0; i < paths.weight.size(); ++i) sum += paths.weight[i] * transmitted(sigma_a, paths.length[i]);
    return sum;
}

Rgb forward_albedo(const Fiber& fiber, const Rgb& sigma_a, float sin_theta) {
    const ForwardPaths paths = forward_paths(fiber, double(sin_theta));
    Rgb result;
    for (int channel = 0; channel < 3; ++channel) result[channel] = float(albedo(paths, double(sigma_a[channel])));
    return result;
}

}  // namespace tress
