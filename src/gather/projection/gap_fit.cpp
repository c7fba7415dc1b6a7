// SPDX-License-Identifier: MIT
#include "gather/projection/gap_fit.h"

#include "core/math.h"

namespace tress {

GapShares fit_gaps(const Means& truth, const std::array<Means, 3>& tried) {
    const size_t n = truth.size();
    const double tried_scatter = double(kTriedGaps[2].scatter);
    Means lost(n), by_gap(n), by_scatter(n);
    for (size_t i = 0; i < n; ++i) {
        lost[i] = truth[i] - tried[0][i];
        by_gap[i] = tried[1][i] - tried[0][i];
        by_scatter[i] = (tried[2][i] - tried[1][i]) / tried_scatter;
    }
    const double gaps = sum(by_gap);
    if (!(gaps > 0 && sum(truth) > 0)) return {};
    const double alone = sum(lost) / gaps;           // the gap's share without scatter
    const double balance = -sum(by_scatter) / gaps;  // what it must rise by for a share of scatter
    double rests = 0, product = 0, squares = 0;
    for (size_t i = 0; i < n; ++i) {
        const double rest = lost[i] - alone * by_gap[i], balanced = by_scatter[i] + balance * by_gap[i];
        rests += square(rest);
        product += rest * balanced;
        squares += square(balanced);
    }
    if (squares > 0) rests -= square(product) / squares;  // the least that any share leaves
    const double noise = std::max(rests, 0.0) / double(n) + square(0x1p-24 * sum(truth) / double(n));  // light is float
    const double known = noise / square(kScatterSpread);
    double scatter = (product + known * double(kUsualGaps.scatter)) / (squares + known);
    if (balance > 0) scatter = std::min(scatter, (double(kMostGap) - alone) / balance);
    scatter = std::max(scatter, 0.0);
    return {glm::clamp(float(alone + balance * scatter), kLeastGap, kMostGap), float(scatter)};
}

}  // namespace tress
