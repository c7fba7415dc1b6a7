// SPDX-License-Identifier: MIT
#include "gather/projection/gap_fit.h"

#include "core/math.h"

namespace tress {
namespace {

constexpr double kLeastNoise = 0.005;  // of the mean: two or three points would always seem to fit without any

}  // namespace

GapShares fit_gaps(const Luminances& truth, const std::array<Luminances, 3>& tried) {
    static_assert(kTriedGaps[0].gap == 0 && kTriedGaps[1].gap == 1 && kTriedGaps[2].gap == 1);
    const size_t n = truth.size();
    Luminances lost(n), by_gap(n), by_scatter(n);
    for (size_t i = 0; i < n; ++i) {
        lost[i] = truth[i] - tried[0][i];
        by_gap[i] = tried[1][i] - tried[0][i];
        by_scatter[i] = (tried[2][i] - tried[1][i]) / double(kTriedGaps[2].scatter);
    }
    const double gaps = total(by_gap);
    if (!(gaps > 0)) return kUsualGaps;
    const double alone = total(lost) / gaps;           // the gap's share without scatter
    const double balance = -total(by_scatter) / gaps;  // what it must rise by for a share of scatter
    double rests = 0, product = 0, squares = 0;
    for (size_t i = 0; i < n; ++i) {
        const double rest = lost[i] - alone * by_gap[i], balanced = by_scatter[i] + balance * by_gap[i];
        rests += square(rest);
        product += rest * balanced;
        squares += square(balanced);
    }
    if (squares > 0) rests -= square(product) / squares;  // the least that any share leaves
    const double noise = std::max(rests / std::max(double(n) - 2, 1.0), square(kLeastNoise * total(truth) / double(n)));
    const double known = noise / square(kScatterSpread);
    double scatter = (product + known * double(kUsualGaps.scatter)) / (squares + known);
    if (balance > 0) scatter = std::min(scatter, (double(kMostGap) - alone) / balance);
    scatter = glm::clamp(scatter, 0.0, double(kMostScatter));
    return {glm::clamp(float(alone + balance * scatter), kLeastGap, kMostGap), float(scatter)};
}

}  // namespace tress
