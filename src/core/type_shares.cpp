// SPDX-License-Identifier: MIT
#include "core/type_shares.h"

#include <cmath>

namespace tress {
namespace {

double luminance_of(const glm::dvec3& v) { return 0.2126 * v.x + 0.7152 * v.y + 0.0722 * v.z; }

/// Weight of a pixel in the mean.
double weight_of(const Film& film, size_t pixel, ShareOf where) {
    return where == ShareOf::picture ? 1 : double(film.hair_hits[pixel]) / glm::max(1u, film.samples[pixel]);
}

/// Mean over pixels, and the standard error that the samples' variance in each pixel gives it.
TypeShare share_of(const Film& film, PathType type, ShareOf where) {
    const TypeSums& sums = film.types[size_t(index_of(type))];
    double mean = 0, variance = 0, weights = 0;
    for (size_t i = 0; i < sums.light.size(); ++i) {
        const double n = glm::max(1u, film.samples[i]), sum = luminance_of(sums.light[i]);
        const double weight = weight_of(film, i, where);
        weights += weight;
        mean += weight * sum / n;
        if (n > 1) variance += square(weight) * glm::max(sums.squares[i] - sum * sum / n, 0.0) / (n * (n - 1));
    }
    if (weights == 0) return {type, 0, 0, 0, 0};
    return {type, mean / weights, std::sqrt(variance) / weights, 0, 0};
}

}  // namespace

std::vector<TypeShare> type_shares(const Film& film, ShareOf where) {
    std::vector<TypeShare> shares;
    double whole = 0, variance = 0;
    for (int t = 0; t < kPathTypes; ++t) {
        if (film.types[size_t(t)].light.empty()) continue;
        shares.push_back(share_of(film, PathType(t), where));
        whole += shares.back().mean;
        variance += square(shares.back().mean_error);
    }
    if (!(whole > 0)) return shares;
    for (TypeShare& s : shares) {
        // Of the ratio m / (m + rest), to first order, types taken as independent.
        const double share = s.mean / whole, own = square(s.mean_error);
        s.percent = 100 * share;
        s.percent_error = 100 * std::sqrt(square(1 - share) * own + square(share) * (variance - own)) / whole;
    }
    return shares;
}

}  // namespace tress
