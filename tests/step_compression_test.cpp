// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/step_compression.h"

#include <doctest/doctest.h>

#include <limits>

#include "tools/check/support/step_functions.h"

using namespace tress;

namespace {

StepNodes compressed(const Steps& steps, float bound) {
    StepNodes nodes;
    StepCompressor()(steps.view(), bound, nodes);
    return nodes;
}

/// One channel from depths and values.
Steps make_steps(std::vector<float> depth, std::vector<float> value) {
    Steps steps;
    steps.depth = std::move(depth), steps.value[0] = std::move(value);
    return steps;
}

/// Nodes that the paper's way takes: from a fixed node on a range of slopes is narrowed until it is empty; the middle
/// one leads to the next node. Depths must differ.
size_t count_by_fixed_nodes(const Steps& steps, double bound) {
    const size_t m = steps.depth.size();
    const auto value = [&](size_t i) { return double(steps.value[0][i]); };
    size_t count = 1, at = 0;
    double y = 1;
    if (value(0) + bound < 1) ++count, y = value(0);
    while (at + 1 < m) {
        double low = -INFINITY, high = 0;
        size_t i = at + 1;
        bool drop = false;
        for (; i < m; ++i) {
            const double dz = double(steps.depth[i]) - double(steps.depth[at]);
            const double least = std::max((value(i - 1) - bound - y) / dz, low);
            const double most = std::min((value(i) + bound - y) / dz, high);
            const double before = std::min((value(i - 1) + bound - y) / dz, high);
            drop = value(i - 1) - value(i) > 2 * bound && least <= before;
            if (drop || least > most) break;
            low = least, high = most;
        }
        if (drop) {
            count += 2, y = value(i), at = i;
        } else {
            ++count;
            y += 0.5 * (low + high) * (double(steps.depth[i - 1]) - double(steps.depth[at]));
            at = i - 1;
        }
    }
    return count;
}

}  // namespace

TEST_CASE("compression keeps its bound on both sides of every step, falls, and starts exactly") {
    StepCompressor compress;
    StepNodes nodes;
    double largest_share[std::size(kStepBounds)] = {};
    for (uint64_t i = 0; i < 100'000; ++i) {
        const StepCase tried = step_case(i);
        const float bound = kStepBounds[tried.bound];
        compress(tried.steps.view(), bound, nodes);
        const double error = greatest_error(tried.steps, nodes);
        const bool good = well_formed(tried.steps, nodes) && error <= double(bound);
        CAPTURE(i);
        CAPTURE(bound);
        CAPTURE(error);
        if (!good) REQUIRE(good);
        largest_share[tried.bound] = std::max(largest_share[tried.bound], error / double(bound));
    }
    // The bound is used: were it halved, this test would fail.
    for (size_t b = 1; b < std::size(kStepBounds); ++b) CHECK(largest_share[b] > 0.99);
}

TEST_CASE("steps of a hair's shape take ever fewer nodes as the bound grows, and fewer than with fixed nodes") {
    size_t before = SIZE_MAX;
    for (const float bound : {0.0f, 0.002f, 0.005f, 0.01f, 0.02f, 0.05f, 0.1f, 0.5f}) {
        CAPTURE(bound);
        size_t count = 0, by_fixed_nodes = 0;
        for (uint64_t i = 0; i < 200; ++i) {
            const Steps steps = random_steps(hash(3, i), 0, 100, 1);
            count += compressed(steps, bound).depth.size();
            by_fixed_nodes += count_by_fixed_nodes(steps, bound);
        }
        CHECK(count < before);
        CHECK(count <= by_fixed_nodes);
        before = count;
    }
    CHECK(before == 2 * 200);  // from 1 to 0.05 within 0.5: one line
}

TEST_CASE("nothing is lost with a bound of 0: each step of some height is two nodes") {
    const Steps steps = make_steps({1, 2, 2, 3, 4, 5}, {0.9f, 0.8f, 0.7f, 0.7f, 1e-40f, 0});
    const StepNodes nodes = compressed(steps, 0);
    CHECK(nodes.depth == std::vector<float>{1, 1, 2, 2, 4, 4, 5, 5});
    CHECK(nodes.value[0] == std::vector<float>{1, 0.9f, 0.9f, 0.7f, 0.7f, 1e-40f, 1e-40f, 0});
}

TEST_CASE("no steps, one step, and steps of no height") {
    CHECK(compressed({}, 0.01f).depth.empty());
    for (const float bound : {0.0f, 0.01f}) {
        const StepNodes one = compressed(make_steps({7}, {0.25f}), bound);
        CHECK(one.depth == std::vector<float>{7, 7});
        CHECK(one.value[0] == std::vector<float>{1, 0.25f});
        const StepNodes flat = compressed(make_steps({7, 8, 9}, {1, 1, 1}), bound);
        CHECK(flat.depth == std::vector<float>{7});
        CHECK(flat.value[0] == std::vector<float>{1});
    }
    CHECK(compressed(make_steps({1, 2}, {0.5f, 0.25f}), 1).depth == std::vector<float>{1});
}

TEST_CASE("a step higher than twice the bound is a drop at its depth, whatever lies around it") {
    Steps steps;
    for (int i = 0; i < 100; ++i) {
        steps.depth.push_back(float(i));
        steps.value[0].push_back((i < 50 ? 1.0f : 0.5f) - 0.001f * float(i));
    }
    const StepNodes nodes = compressed(steps, 0.01f);
    CHECK(nodes.depth == std::vector<float>{0, 50, 50, 99});
    CHECK(greatest_error(steps, nodes) <= 0.01f);
}

TEST_CASE("the ends of what floats hold: depths one apart in the last bit, 1e30, denormal, and 1e4 steps") {
    const float lowest = std::numeric_limits<float>::denorm_min();
    struct Case {
        const char* name;
        float start, factor;  // the next depth: the next float, or a multiple
    };
    for (const Case& set : {Case{"next", 36, 0}, Case{"next, huge", 1e30f, 0}, Case{"next, denormal", lowest, 0},
                            Case{"tenfold", 1e-37f, 10}, Case{"a little", 1e20f, 1.001f}}) {
        CAPTURE(set.name);
        for (const float bound : {0.0f, 1e-7f, 1e-6f, 1e-3f, 0.1f}) {
            CAPTURE(bound);
            Steps steps;
            float depth = set.start, left = 1;
            for (uint64_t i = 0; i < 10'000; ++i) {
                steps.depth.push_back(depth);
                steps.value[0].push_back(left *= 1 - 0.02f * random(4, i));
                const float next = set.factor > 0 ? depth * set.factor : std::nextafter(depth, INFINITY);
                depth = next < 1e38f ? next : depth;
            }
            const StepNodes nodes = compressed(steps, bound);
            CHECK(well_formed(steps, nodes));
            CHECK(greatest_error(steps, nodes) <= double(bound));
        }
    }
}

TEST_CASE("a compressor that is used again gives what a new one gives") {
    StepCompressor compress;
    StepNodes nodes;
    for (uint64_t i = 0; i < 100; ++i) {
        const Steps steps = random_steps(hash(5, i), int(i % kStepShapes), 1 + i, i % 3 ? 1 : 3);
        compress(steps.view(), 0.01f, nodes);
        const StepNodes fresh = compressed(steps, 0.01f);
        CHECK(nodes.depth == fresh.depth);
        for (int c = 0; c < 3; ++c) CHECK(nodes.value[c] == fresh.value[c]);
    }
}
