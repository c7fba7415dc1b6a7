// SPDX-License-Identifier: MIT
// Random falling step functions of many shapes, and how far nodes are from them, by definition and in double.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "core/rng.h"
#include "gather/shadow_maps/step_compression.h"

namespace tress {

struct Steps {
    std::vector<float> depth, value[3];

    StepFunction view() const { return {depth, {value[0], value[1], value[2]}}; }
};

inline constexpr int kStepShapes = 10;

/// Gap to the next depth, and share of the light that a step takes, of one shape.
inline float next_depth(int shape, float depth, float u) {
    const float gap = -std::log(1 - u);  // exponential: a Poisson process
    switch (shape) {
        case 3:
            return depth + float(gap > 1);  // several at one depth
        case 5:
            return u < 0.9f ? std::nextafter(depth, 1e9f) : depth + 1e-3f * gap;
        case 7:
            return depth * (1 + 2 * gap);  // 1e-30 to 1e30 and more
        case 8:
            return depth < 0 ? depth * u : depth + u;  // towards 0 and away from it
        default:
            return depth + gap;
    }
}
inline float next_opacity(int shape, float u, float w) {
    switch (shape) {
        case 1:
            return w < 0.03f ? u : 0;  // cliffs
        case 2:
            return w < 0.2f ? 0.3f * u : 0;  // plateaus, steps of no height between
        case 4:
            return w < 0.02f ? 1 : u * u;  // down to 0
        case 6:
            return 1 - 1e-6f * (1 - u);  // through the denormals
        case 9:
            return 1e-3f * u;  // smooth
        default:
            return 0.06f * u;  // hair: c (1 - a)
    }
}

inline Steps random_steps(uint64_t key, int shape, size_t count, int channels) {
    Steps steps;
    float depth = shape == 7 ? 1e-30f : (shape == 8 ? -1e30f : (shape == 5 ? 100.0f : random(key, 0)));
    float left[3] = {1, 1, 1};
    for (size_t i = 0; i < count; ++i) {
        const uint64_t own = hash(key, i + 1);
        const float along = random(own, 0), rare = random(own, 1);
        const float farther = next_depth(shape, depth, along);
        if (std::isfinite(farther)) depth = farther;
        steps.depth.push_back(depth);
        for (int c = 0; c < channels; ++c) {
            left[c] *= 1 - next_opacity(shape, random(own, 2 + uint64_t(c)), rare);
            steps.value[c].push_back(left[c]);
        }
    }
    return steps;
}

/// Random steps of every shape, of 1 to 300 steps and one channel or three, with a bound for them: case `i` of as many
/// as are wanted.
struct StepCase {
    Steps steps;
    size_t bound;  // index of kStepBounds
};
inline constexpr float kStepBounds[] = {0, 1e-3f, 0.01f, 0.05f, 0.2f};

inline StepCase step_case(uint64_t i) {
    const int shape = int(i % kStepShapes), channels = i / kStepShapes % 2 ? 3 : 1;
    const float length = random(hash(1, i), 0);
    const size_t count = 1 + size_t(300 * length * length * length);
    return {random_steps(hash(2, i), shape, count, channels), size_t(i / (2 * kStepShapes) % std::size(kStepBounds))};
}

/// A value a node in every channel.
inline bool is_whole(const Steps& steps, const StepNodes& nodes) {
    bool whole = !nodes.depth.empty();
    for (int c = 0; c < steps.view().channels(); ++c) whole &= nodes.value[c].size() == nodes.depth.size();
    return whole;
}
/// The first node is the first step's depth to the bit, and 1.
inline bool starts_exactly(const Steps& steps, const StepNodes& nodes) {
    if (!is_whole(steps, nodes)) return false;
    bool exact = std::bit_cast<uint32_t>(nodes.depth[0]) == std::bit_cast<uint32_t>(steps.depth[0]);
    for (int c = 0; c < steps.view().channels(); ++c) exact &= nodes.value[c][0] == 1.0f;
    return exact;
}
/// Depths in order, at most two at one; values do not rise.
inline bool is_monotone(const Steps& steps, const StepNodes& nodes) {
    if (!is_whole(steps, nodes)) return false;
    const size_t n = nodes.depth.size();
    bool falls = true;
    for (size_t i = 1; i < n; ++i) falls &= nodes.depth[i] >= nodes.depth[i - 1];
    for (size_t i = 2; i < n; ++i) falls &= nodes.depth[i] > nodes.depth[i - 2];
    for (int c = 0; c < steps.view().channels(); ++c)
        for (size_t i = 1; i < n; ++i) falls &= nodes.value[c][i] <= nodes.value[c][i - 1];
    return falls;
}
/// All values lie in [0, 1].
inline bool is_within_unit(const Steps& steps, const StepNodes& nodes) {
    bool within = is_whole(steps, nodes);
    for (int c = 0; c < steps.view().channels(); ++c)
        for (const float v : nodes.value[c]) within &= v >= 0 && v <= 1;
    return within;
}
inline bool well_formed(const Steps& steps, const StepNodes& nodes) {
    return starts_exactly(steps, nodes) && is_monotone(steps, nodes) && is_within_unit(steps, nodes);
}

/// V' just before a depth, where `node` is the first that is not before it; just behind it, where `node` is the first
/// that is behind it.
inline double node_value(const StepNodes& nodes, int c, size_t node, double depth) {
    if (node == 0) return 1;
    if (node == nodes.depth.size()) return nodes.value[c].back();
    const double from = nodes.depth[node - 1], to = nodes.depth[node];
    const double a = nodes.value[c][node - 1], b = nodes.value[c][node];
    return a + (b - a) * ((depth - from) / (to - from));
}

/// Greatest |V - V'| of a channel: on both sides of all depths of both functions, and half way between them.
inline double greatest_error(const Steps& steps, const StepNodes& nodes, int c) {
    const size_t m = steps.depth.size(), n = nodes.depth.size();
    const auto step_value = [&](size_t step) { return step == 0 ? 1.0 : double(steps.value[c][step - 1]); };
    double worst = 0;
    size_t step = 0, node = 0;  // how many depths lie before here
    const auto compare = [&](double depth) {
        worst = std::max(worst, std::abs(step_value(step) - node_value(nodes, c, node, depth)));
    };
    while (step < m || node < n) {
        const float here = std::min(step < m ? steps.depth[step] : INFINITY, node < n ? nodes.depth[node] : INFINITY);
        compare(here);
        while (step < m && steps.depth[step] == here) ++step;
        while (node < n && nodes.depth[node] == here) ++node;
        compare(here);
        if (step == m && node == n) break;
        const float next = std::min(step < m ? steps.depth[step] : INFINITY, node < n ? nodes.depth[node] : INFINITY);
        compare(0.5 * (double(here) + double(next)));
    }
    return worst;
}
/// Of all channels.
inline double greatest_error(const Steps& steps, const StepNodes& nodes) {
    double worst = 0;
    for (int c = 0; c < steps.view().channels(); ++c) worst = std::max(worst, greatest_error(steps, nodes, c));
    return worst;
}

}  // namespace tress
