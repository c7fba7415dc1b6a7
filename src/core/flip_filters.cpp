// SPDX-License-Identifier: MIT
#include "core/flip_filters.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/math.h"

namespace tress {
namespace {

constexpr double kPi64 = std::numbers::pi;

/// a sqrt(pi / b) exp(-pi^2 d^2 / b) at d degrees (Andersson et al. 2020, table 1; after Movshon and Johnson).
struct Gaussian {
    double a, b;
};
constexpr Gaussian kAchromatic{1, 0.0047}, kRedGreen{1, 0.0053};
constexpr Gaussian kBlueYellow[2]{{34.1, 0.04}, {13.5, 0.025}};
constexpr double kWidest = 0.04;         // the largest b of all: its radius is every channel's
constexpr double kDeviations = 3;        // a filter's radius, in standard deviations
constexpr double kFeatureWidth = 0.082;  // degrees: the width of an edge the eye sees best (sec. 4.2)

double weight_at(const Gaussian& g, double degrees) {
    return g.a * std::sqrt(kPi64 / g.b) * std::exp(-square(kPi64 * degrees) / g.b);
}

std::vector<double> sample_gaussian(double deviation, int radius) {
    std::vector<double> value;
    for (int x = -radius; x <= radius; ++x) value.push_back(std::exp(-0.5 * square(x / deviation)));
    return value;
}

double sum(const std::vector<double>& values) {
    double total = 0;
    for (double v : values) total += v;
    return total;
}

/// Weights times `scale`, without the ends that are nothing to single precision.
Kernel make_kernel(std::vector<double> weight, double scale) {
    size_t skip = 0;
    const size_t middle = weight.size() / 2;
    constexpr double kNothing = std::numeric_limits<float>::epsilon() / 16;
    while (skip < middle && std::abs(weight[skip]) < kNothing * std::abs(weight[middle])) ++skip;
    Kernel kernel;
    for (size_t i = skip; i + skip < weight.size(); ++i) kernel.weight.push_back(float(weight[i] * scale));
    return kernel;
}

/// A channel of one or two Gaussians, each separable: exp(-(x^2 + y^2)) = exp(-x^2) exp(-y^2).
template <size_t N>
void make_channel(const Gaussian (&gaussians)[N], double pixels_per_degree, SensitivityTerm* terms) {
    const int radius = int(std::ceil(kDeviations * std::sqrt(kWidest / (2 * kPi64 * kPi64)) * pixels_per_degree));
    std::vector<double> shape[N];
    double total = 0;
    for (size_t i = 0; i < N; ++i) {
        const double deviation = std::sqrt(gaussians[i].b / (2 * kPi64 * kPi64)) * pixels_per_degree;
        shape[i] = sample_gaussian(deviation, radius);
        total += weight_at(gaussians[i], 0) * square(sum(shape[i]));
    }
    for (size_t i = 0; i < N; ++i) {
        terms[i].row = make_kernel(shape[i], weight_at(gaussians[i], 0) / total);
        terms[i].column = make_kernel(shape[i], 1);
    }
}

/// Scales so that the positive weights sum to 1 and the negative ones to -1.
Kernel balanced(std::vector<double> weight) {
    double positive = 0, negative = 0;
    for (double w : weight) (w > 0 ? positive : negative) += w;
    Kernel kernel;
    for (double w : weight) kernel.weight.push_back(float(w > 0 ? w / positive : -w / negative));
    return kernel;
}

}  // namespace

FlipFilters make_flip_filters(double pixels_per_degree) {
    FlipFilters filters;
    make_channel({kAchromatic}, pixels_per_degree, &filters.achromatic);
    make_channel({kRedGreen}, pixels_per_degree, &filters.red_green);
    make_channel(kBlueYellow, pixels_per_degree, filters.blue_yellow);

    const double deviation = 0.5 * kFeatureWidth * pixels_per_degree;
    const int radius = int(std::ceil(kDeviations * deviation));
    const std::vector<double> gaussian = sample_gaussian(deviation, radius);
    std::vector<double> first, second;
    for (int x = -radius; x <= radius; ++x) {
        const double g = gaussian[size_t(x + radius)];
        first.push_back(-x * g);
        second.push_back((square(x / deviation) - 1) * g);
    }
    filters.smooth = make_kernel(gaussian, 1 / sum(gaussian));
    filters.edge = balanced(first);
    filters.point = balanced(second);
    return filters;
}

}  // namespace tress
