// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/cluster_runs.h"

#include <numeric>

#include "core/math.h"

namespace tress {
namespace {

/// Sums start at the middle of the points: those of depths far from 0 would cancel.
void sum_moments(const WeightedDepths& points, ClusterRuns& runs) {
    const double middle = 0.5 * (points.depth.front() + points.depth.back());
    runs.moments.assign(1, {});
    for (size_t k = 0; k < points.depth.size(); ++k) {
        const DepthMoments before = runs.moments.back();
        const double weight = points.weight[k];
        runs.moments.push_back({before.weight + weight, before.first + weight * (points.depth[k] - middle)});
    }
}

/// Weight times squared mean of points [from, to): what they cost less as a run than about the middle, each for itself.
/// Beside heavier ones their weight may be lost in rounding: then it gains nothing.
double run_gain(const DepthMoments& from, const DepthMoments& to) {
    const double weight = to.weight - from.weight;
    return weight > 0 ? square(to.first - from.first) / weight : 0;
}

struct Best {
    double gain = -1;
    uint32_t start = 0;
};

/// The best start, in [from, to], of a last run that ends at `end`; the points before it gain runs.gain.
Best best_start(const ClusterRuns& runs, size_t from, size_t to, size_t end) {
    Best best;
    const DepthMoments at_end = runs.moments[end];
    for (size_t start = from; start <= to; ++start) {
        const double gain = runs.gain[start] + run_gain(runs.moments[start], at_end);
        if (gain > best.gain) best = {gain, uint32_t(start)};
    }
    return best;
}

/// Best starts of run `run` for all ends in [low, high), known to lie in [from, to]: the best start never falls as the
/// end rises, so the one for the middle end bounds the others. Nor does it fall as runs are added (but where gains are
/// equal to rounding: the range is never empty).
void add_run(ClusterRuns& runs, size_t run, size_t low, size_t high, size_t from, size_t to) {
    if (low >= high) return;
    const size_t stride = runs.gain.size(), end = low + (high - low) / 2;
    const size_t last = glm::min(to, end - 1), of_fewer = runs.start[(run - 1) * stride + end];
    const Best best = best_start(runs, glm::min(glm::max(from, of_fewer), last), last, end);
    runs.next_gain[end] = best.gain;
    runs.start[run * stride + end] = best.start;
    add_run(runs, run, low, end, from, best.start);
    add_run(runs, run, end + 1, high, best.start, to);
}

}  // namespace

void best_runs(const WeightedDepths& points, int clusters, ClusterRuns& runs) {
    const size_t count = points.depth.size(), wanted = glm::min(size_t(clusters), count), stride = count + 1;
    runs.end.resize(wanted);
    std::iota(runs.end.begin(), runs.end.end(), 1u);
    if (wanted == count) return;

    sum_moments(points, runs);
    runs.start.assign(wanted * stride, 0);
    runs.gain.assign(stride, 0);
    for (size_t end = 1; end < stride; ++end) runs.gain[end] = run_gain(runs.moments[0], runs.moments[end]);
    runs.next_gain = runs.gain;
    for (size_t run = 1; run + 1 < wanted; ++run) {
        add_run(runs, run, run + 1, stride, run, count - 1);
        swap(runs.gain, runs.next_gain);
    }

    // The last run ends with the points; the others end where the next one starts.
    runs.end[wanted - 1] = uint32_t(count);
    if (wanted == 1) return;
    const size_t least = glm::max(wanted - 1, size_t(runs.start[(wanted - 2) * stride + count]));
    runs.end[wanted - 2] = best_start(runs, least, count - 1, count).start;
    for (size_t run = wanted - 2; run > 0; --run) runs.end[run - 1] = runs.start[run * stride + runs.end[run]];
}

}  // namespace tress
