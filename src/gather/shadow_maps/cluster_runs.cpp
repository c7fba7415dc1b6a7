// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/cluster_runs.h"

#include <limits>
#include <numeric>

#include "core/math.h"

namespace tress {
namespace {

/// Sums start at the middle of the points: squares of depths far from 0 would cancel.
void sum_moments(const WeightedDepths& points, ClusterRuns& runs) {
    const double middle = 0.5 * (points.depth.front() + points.depth.back());
    runs.weight.assign(1, 0);
    runs.first.assign(1, 0);
    runs.second.assign(1, 0);
    for (size_t k = 0; k < points.depth.size(); ++k) {
        const double offset = points.depth[k] - middle, weight = points.weight[k];
        runs.weight.push_back(runs.weight.back() + weight);
        runs.first.push_back(runs.first.back() + weight * offset);
        runs.second.push_back(runs.second.back() + weight * offset * offset);
    }
}

/// Of points [from, to) as one run. Their weight is lost in rounding beside heavier ones, at worst: then it costs none.
double run_cost(const ClusterRuns& runs, size_t from, size_t to) {
    const double weight = runs.weight[to] - runs.weight[from];
    return weight > 0 ? runs.second[to] - runs.second[from] - square(runs.first[to] - runs.first[from]) / weight : 0;
}

struct Best {
    double cost = std::numeric_limits<double>::infinity();
    uint32_t start = 0;
};

/// The best start, in [from, to], of a last run that ends at `end`; the points before it cost runs.cost.
Best best_start(const ClusterRuns& runs, size_t from, size_t to, size_t end) {
    Best best{.start = uint32_t(from)};
    for (size_t start = from; start <= to; ++start) {
        const double cost = runs.cost[start] + run_cost(runs, start, end);
        if (cost < best.cost) best = {cost, uint32_t(start)};
    }
    return best;
}

/// Best starts of run `run` for all ends in [low, high), known to lie in [from, to]: the best start never falls as the
/// end rises, so the one for the middle end bounds the others. Nor does it fall as runs are added (but where costs are
/// equal to rounding: the range is never empty).
void add_run(ClusterRuns& runs, size_t run, size_t low, size_t high, size_t from, size_t to) {
    if (low >= high) return;
    const size_t stride = runs.cost.size(), end = low + (high - low) / 2;
    const size_t last = glm::min(to, end - 1), of_fewer = runs.start[(run - 1) * stride + end];
    const Best best = best_start(runs, glm::min(glm::max(from, of_fewer), last), last, end);
    runs.next_cost[end] = best.cost;
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
    runs.cost.assign(stride, 0);
    for (size_t end = 1; end < stride; ++end) runs.cost[end] = run_cost(runs, 0, end);
    runs.next_cost = runs.cost;
    for (size_t run = 1; run + 1 < wanted; ++run) {
        add_run(runs, run, run + 1, stride, run, count - 1);
        swap(runs.cost, runs.next_cost);
    }

    // The last run ends with the points; the others end where the next one starts.
    runs.end[wanted - 1] = uint32_t(count);
    if (wanted == 1) return;
    const size_t least = glm::max(wanted - 1, size_t(runs.start[(wanted - 2) * stride + count]));
    runs.end[wanted - 2] = best_start(runs, least, count - 1, count).start;
    for (size_t run = wanted - 2; run > 0; --run) runs.end[run - 1] = runs.start[run * stride + runs.end[run]];
}

}  // namespace tress
