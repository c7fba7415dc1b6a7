// SPDX-License-Identifier: MIT
#include "core/rank_correlation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace tress {
namespace {

/// Ranks less their mean.
std::vector<double> centred_ranks(std::span<const double> values) {
    const size_t n = values.size();
    std::vector<size_t> order(n);
    std::iota(order.begin(), order.end(), size_t(0));
    std::sort(order.begin(), order.end(), [&](size_t i, size_t j) { return values[i] < values[j]; });
    std::vector<double> ranks(n);
    for (size_t first = 0, last = 0; first < n; first = last) {
        while (last < n && values[order[last]] == values[order[first]]) ++last;
        for (size_t k = first; k < last; ++k) ranks[order[k]] = 0.5 * (double(first) + double(last)) - 0.5 * double(n);
    }
    return ranks;
}

}  // namespace

double rank_correlation(std::span<const double> a, std::span<const double> b) {
    const std::vector<double> x = centred_ranks(a), y = centred_ranks(b);
    const auto product = [](const std::vector<double>& u, const std::vector<double>& v) {
        return std::inner_product(u.begin(), u.end(), v.begin(), 0.0);
    };
    return product(x, y) / std::sqrt(product(x, x) * product(y, y));  // 0 / 0 where there is no order
}

}  // namespace tress
