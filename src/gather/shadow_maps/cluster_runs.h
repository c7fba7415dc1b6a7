// SPDX-License-Identifier: MIT
// k-means in one dimension, solved exactly: clusters of points in order are runs of them, and dynamic programming finds
// the best (Wang & Song 2011). No start to choose, no iterations to count.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace tress {

/// Points of different depths, in the order of depth.
struct WeightedDepths {
    std::vector<double> depth, weight;  // weights above 0
};

/// Of all points before one.
struct DepthMoments {
    double weight = 0, first = 0;  // sums of weights, and of weights times depth
};

/// Memory of best_runs, kept from call to call.
struct ClusterRuns {
    std::vector<DepthMoments> moments;    // of the points before each; depth from the middle
    std::vector<double> gain, next_gain;  // of the first j points in the best runs
    std::vector<uint32_t> start;          // [run * (points + 1) + j]: where the last of those runs starts
    std::vector<uint32_t> end;            // the answer: one past the last point of each run
};

/// Fills runs.end: min(clusters, points) runs, none empty, with the least sum of weight times squared distance from the
/// run's mean. O(clusters points log points).
void best_runs(const WeightedDepths& points, int clusters, ClusterRuns& runs);

}  // namespace tress
