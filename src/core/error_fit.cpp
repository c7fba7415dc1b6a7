// SPDX-License-Identifier: MIT
#include "core/error_fit.h"

#include <algorithm>
#include <cmath>

namespace tress {
namespace {

constexpr int kRounds = 50;            // of weights: they settle in far fewer
constexpr double kSingular = 1e-9;     // of a determinant, relative to its terms
constexpr double kLeastShare = 1e-12;  // of the mean error: keeps weights finite

bool usable(const ErrorPoint& p) {
    return std::isfinite(p.seconds) && std::isfinite(p.error) && p.seconds > 0 && p.error > 0;
}

/// Sums of weighted least squares of error against x = 1 / seconds.
struct Sums {
    double w = 0, x = 0, xx = 0, y = 0, xy = 0;

    void add(double weight, double x1, double y1) {
        w += weight, x += weight * x1, xx += weight * x1 * x1, y += weight * y1, xy += weight * x1 * y1;
    }
};

/// Both parts from the sums; a part that would be negative is 0 and the other fitted alone.
void solve(const Sums& s, ErrorFit& fit) {
    const double determinant = s.w * s.xx - s.x * s.x;
    fit.floor = 0;
    fit.noise = s.xy / s.xx;
    if (!(determinant > kSingular * s.w * s.xx)) return;
    const double floor = (s.xx * s.y - s.x * s.xy) / determinant, noise = (s.w * s.xy - s.x * s.y) / determinant;
    if (floor <= 0) return;
    fit.floor = noise > 0 ? floor : s.y / s.w;
    fit.noise = std::max(noise, 0.0);
}

ErrorFit fit_points(const std::vector<ErrorPoint>& points) {
    ErrorFit fit;
    if (points.empty()) return fit;
    double mean = 0;
    for (const ErrorPoint& p : points) mean += p.error / double(points.size());
    for (int round = 0; round < kRounds; ++round) {
        Sums sums;
        for (const ErrorPoint& p : points) {
            const double expected = round == 0 ? p.error : std::max(fit.at(p.seconds), kLeastShare * mean);
            sums.add(1 / (expected * expected), 1 / p.seconds, p.error);
        }
        solve(sums, fit);
    }
    double squares = 0;
    for (const ErrorPoint& p : points) squares += std::pow(p.error / fit.at(p.seconds) - 1, 2);
    fit.residual = std::sqrt(squares / double(points.size()));
    return fit;
}

/// Usable points of all runs but one.
std::vector<ErrorPoint> points_without(std::span<const ErrorRun> runs, size_t left_out) {
    std::vector<ErrorPoint> points;
    for (size_t i = 0; i < runs.size(); ++i)
        if (i != left_out) std::copy_if(runs[i].begin(), runs[i].end(), std::back_inserter(points), usable);
    return points;
}

/// Standard error of an estimate from those made without one of n runs each: sqrt((n - 1) / n sum (v - mean)^2).
double jackknife(const std::vector<double>& values) {
    const double n = double(values.size());
    double mean = 0, squares = 0;
    for (double v : values) mean += v / n;
    for (double v : values) squares += (v - mean) * (v - mean);
    return std::sqrt((n - 1) / n * squares);
}

}  // namespace

ErrorFit fit_error(std::span<const ErrorRun> runs) {
    ErrorFit fit = fit_points(points_without(runs, runs.size()));
    if (runs.size() < 2) return fit;
    std::vector<double> floors, noises;
    for (size_t i = 0; i < runs.size(); ++i) {
        const ErrorFit part = fit_points(points_without(runs, i));
        floors.push_back(part.floor);
        noises.push_back(part.noise);
    }
    fit.floor_error = jackknife(floors);
    fit.noise_error = jackknife(noises);
    return fit;
}

}  // namespace tress
