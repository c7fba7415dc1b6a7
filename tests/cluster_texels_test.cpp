// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/cluster_texels.h"

#include <doctest/doctest.h>

#include "gather/shadow_maps/cluster_runs.h"
#include "tests/texel_fragments.h"

using namespace tress;

namespace {

ClusterTexels clusters(const FragmentTile& tile, int count) { return make_cluster_texels(tile, {.count = count}); }

double depth_of(double opacity) { return opacity < 1 ? std::min(-std::log1p(-opacity), double(kOpaqueDepth)) : 50; }

/// Sums over fragments of optical depth (mean over channels) times the powers of depth.
struct Moments {
    double sum[3] = {};
};

Moments moments_of(const TestTexel& texel) {
    Moments moments;
    for (const TestFragment& fragment : texel) {
        double depth = 0, power = 1;
        for (int c = 0; c < 3; ++c) depth += depth_of(double(fragment.opacity[c])) / 3;
        for (double& sum : moments.sum) {
            sum += depth * power;
            power *= double(fragment.depth);
        }
    }
    return moments;
}

Moments moments_of(const ClusterTexels& texels, size_t row) {
    Moments moments;
    for (size_t k = row * size_t(texels.clusters); k < (row + 1) * size_t(texels.clusters); ++k) {
        double depth = 0;
        for (int c = 0; c < 3; ++c) depth += double(texels.depth[c][k]) / 3;
        const double mean = double(texels.mean[k]), width = double(texels.half_width[k]);
        moments.sum[0] += depth;
        moments.sum[1] += depth * mean;
        moments.sum[2] += depth * (mean * mean + width * width / 3);
    }
    return moments;
}

double cost_of(const WeightedDepths& points, size_t begin, size_t end) {
    double weight = 0, first = 0, cost = 0;
    for (size_t k = begin; k < end; ++k) weight += points.weight[k], first += points.weight[k] * points.depth[k];
    for (size_t k = begin; k < end; ++k) cost += points.weight[k] * square(points.depth[k] - first / weight);
    return cost;
}

/// Of all ways to cut the points from `begin` into runs.
double least_cost(const WeightedDepths& points, size_t begin, int runs) {
    const size_t count = points.depth.size();
    if (runs == 1) return cost_of(points, begin, count);
    double least = std::numeric_limits<double>::infinity();
    for (size_t end = begin + 1; end + size_t(runs) <= count + 1; ++end)
        least = std::min(least, cost_of(points, begin, end) + least_cost(points, end, runs - 1));
    return least;
}

/// Mean absolute error over all depths of [0, 1] and all texels.
double mean_error(const ClusterTexels& texels, const std::vector<TestTexel>& fragments) {
    constexpr int kSamples = 1000;
    double sum = 0;
    for (size_t texel = 0; texel < fragments.size(); ++texel)
        for (int k = 0; k < kSamples; ++k) {
            const float depth = (float(k) + 0.5f) / kSamples;
            const double exact = exact_transmittance(fragments[texel], double(depth));
            sum += std::abs(double(transmittance(texels, texel, depth).x) - exact);
        }
    return sum / double(fragments.size()) / kSamples;
}

}  // namespace

TEST_CASE("runs are the best of all, found by trying every way to cut") {
    ClusterRuns runs;
    for (uint64_t trial = 0; trial < 300; ++trial) {
        WeightedDepths points;
        const int count = 1 + int(trial % 11);
        double place = 1000;  // far from 0: squares of depths would cancel
        for (uint64_t k = 0; k < uint64_t(count); ++k) {
            const bool even = trial % 3 == 0;  // equal costs
            place += even ? 1 : 0.001 + double(random(hash(20, trial), 2 * k));
            points.depth.push_back(place);
            points.weight.push_back(even ? 1 : std::exp(-20 * double(random(hash(20, trial), 2 * k + 1))));
        }
        for (int wanted = 1; wanted <= 6; ++wanted) {
            CAPTURE(trial);
            CAPTURE(wanted);
            best_runs(points, wanted, runs);
            REQUIRE(runs.end.size() == size_t(std::min(wanted, count)));
            CHECK(runs.end.back() == uint32_t(count));
            double cost = 0;
            for (size_t run = 0, begin = 0; run < runs.end.size(); begin = runs.end[run++]) {
                REQUIRE(begin < runs.end[run]);
                cost += cost_of(points, begin, runs.end[run]);
            }
            // Sums of up to 11 weights of 1 times squares of up to 6, and their roundings in double.
            CHECK(cost <= least_cost(points, 0, int(runs.end.size())) + 11 * 36 * 1e-15 * 11);
        }
    }
}

TEST_CASE("behind all hair a texel lets through the product of 1 - opacity") {
    std::vector<TestTexel> fragments = stiff_texels();
    for (uint64_t k = 0; k < 50; ++k) fragments.push_back(random_texel(hash(21, k), int(2 * k), 0, 1, 0.2f));
    const FragmentTile tile = tile_of(fragments, 3);
    for (const int count : {1, 2, 4, 64}) {
        const ClusterTexels texels = clusters(tile, count);
        for (size_t texel = 0; texel < fragments.size(); ++texel)
            for (const float depth : {3.0f, 1e30f, kInfinity})
                for (int c = 0; c < 3; ++c) {
                    CAPTURE(count);
                    CAPTURE(texel);
                    CAPTURE(c);
                    const double exact = exact_transmittance(fragments[texel], 3, c);
                    const double found = double(transmittance(texels, texel, depth)[c]);
                    // Each sum in single precision of the clusters' depths rounds once more.
                    CHECK(std::abs(found - exact) <= transmittance_rounding(exact) * count);
                }
    }
}

TEST_CASE("clusters keep the fragments' sum, mean and variance") {
    std::vector<TestTexel> fragments = random_texels(22, 50, 100, 2, 5, 0.2f);
    fragments.push_back(random_texel(23, 10000, 2, 5, 1e-3f));
    fragments.push_back({{2, Rgb(1)}, {3, Rgb(1e-8f)}, {4, Rgb(0.5f)}, {5, Rgb(0.5f)}});
    for (const int count : {1, 3, 4, 20}) {
        const ClusterTexels texels = clusters(tile_of(fragments, 3), count);
        for (size_t texel = 0; texel < fragments.size(); ++texel) {
            const Moments exact = moments_of(fragments[texel]), kept = moments_of(texels, texel);
            double scale = exact.sum[0];
            for (int power = 0; power < 3; ++power) {
                CAPTURE(count);
                CAPTURE(texel);
                CAPTURE(power);
                // Optical depths are rounded as fragments (log1p) and as clusters; means and widths once each.
                CHECK(std::abs(kept.sum[power] - exact.sum[power]) <= 8 * kRounding * scale);
                scale *= 5;
            }
        }
    }
}

TEST_CASE("as many clusters as there are depths give the step function, however fragments weigh") {
    std::vector<TestTexel> fragments;
    for (uint64_t k = 0; k < 100; ++k) {
        TestTexel texel = random_texel(hash(24, k), 1 + int(k % 8), 0, 1, 1);
        for (TestFragment& fragment : texel) fragment.opacity *= std::pow(10.0f, -float(k % 5));
        const TestTexel again = texel;
        for (const TestFragment& fragment : again)
            for (uint64_t copy = 0; copy < k % 3; ++copy) texel.push_back({fragment.depth, Rgb(0.3f)});
        fragments.push_back(texel);
    }
    const ClusterTexels texels = clusters(tile_of(fragments, 3), 8);
    for (size_t texel = 0; texel < fragments.size(); ++texel)
        for (const TestFragment& fragment : fragments[texel])
            for (const float depth :
                 {std::nextafter(fragment.depth, -1.0f), fragment.depth, std::nextafter(fragment.depth, 2.0f)})
                for (int c = 0; c < 3; ++c) {
                    CAPTURE(texel);
                    CAPTURE(depth);
                    const double exact = exact_transmittance(fragments[texel], double(depth), c);
                    CHECK(std::abs(double(transmittance(texels, texel, depth)[c]) - exact) <=
                          transmittance_rounding(exact) * 2);
                }
}

TEST_CASE("light falls with depth and stays between 0 and 1 whatever the depth") {
    std::vector<TestTexel> fragments = stiff_texels();
    fragments.push_back({});
    fragments.push_back(random_texel(25, 100, 0, 1, 0.2f));
    const FragmentTile tile = tile_of(fragments, 3);
    for (const int count : {1, 4, 16}) check_light_falls(clusters(tile, count), fragments.size(), -1000, 2000);
}

TEST_CASE("between clumps that stand apart the light is exact, be one of them ten times as heavy") {
    TestTexel texel;
    const float starts[] = {0, 1, 2, 3};
    for (uint64_t clump = 0; clump < 4; ++clump) {
        const float most = clump == 2 ? 0.1f : 0.01f;
        for (const TestFragment& fragment :
             random_texel(hash(26, clump), 30, starts[clump], starts[clump] + 0.25f, most))
            texel.push_back(fragment);
    }
    const ClusterTexels texels = clusters(tile_of({texel}), 4);
    // Two light clumps, of 0.15 each, as one would cost 0.07 by the distance of 1 between them; the heavy one, of 1.5,
    // cut in two would save less than its whole cost of 1.5 * 0.25 * 0.25 / 4 = 0.023. So the clumps are the clusters.
    // Whatever lies in a width w has a standard deviation of at most w / 2: its slab reaches less than sqrt(3) / 2 w
    // beyond it, 0.22 here.
    for (const float depth : {-0.23f, 0.48f, 0.77f, 1.48f, 1.77f, 2.48f, 2.77f, 3.48f}) {
        const double exact = exact_transmittance(texel, double(depth));
        CAPTURE(depth);
        CHECK(std::abs(double(transmittance(texels, 0, depth).x) - exact) <= 4 * transmittance_rounding(exact));
    }
}

TEST_CASE("the mean error falls as clusters are added") {
    const std::vector<TestTexel> fragments = random_texels(27, 200, 64, 0, 1, 0.1f);
    const FragmentTile tile = tile_of(fragments);
    double before = mean_error(clusters(tile, 1), fragments);
    for (const int count : {4, 16}) {
        const double error = mean_error(clusters(tile, count), fragments);
        CAPTURE(count);
        CAPTURE(error);
        // The number of fragments in part of a cluster wanders as its root: half, for a quarter of the fragments in
        // each. An eighth is left for chance: 200 texels.
        CHECK(error < before * 0.5 * 1.125);
        before = error;
    }
    CHECK(mean_error(clusters(tile, 64), fragments) <= transmittance_rounding(1) * 64);
}

TEST_CASE("texels without hair, or with hair that stops nothing, let all light through and cost an index") {
    const ClusterTexels texels = clusters(tile_of({{}, {{0.5f, Rgb(0)}}, {{0.5f, Rgb(0.5f)}}, {}}), 4);
    for (const size_t texel : {0u, 1u, 3u}) CHECK(transmittance(texels, texel, 2) == Rgb(1));
    CHECK(bytes(texels) == 4 * 4 + 4 * 3 * 4);
}

TEST_CASE("appended tiles keep what each lets through") {
    const std::vector<FragmentTile> tiles = {tile_of({{}, {}}, 3), tile_of(random_texels(28, 5, 30, 0, 1, 0.2f), 3),
                                             tile_of({{}}, 3),
                                             tile_of({{{0.5f, Rgb(0.1f, 0.2f, 0.3f)}}, {}, {{0.7f, Rgb(0.5f)}}}, 3)};
    ClusterTexels all;
    std::vector<ClusterTexels> parts;
    size_t sum = 0;
    for (const FragmentTile& tile : tiles) {
        parts.push_back(clusters(tile, 4));
        append(all, parts.back());
        sum += bytes(parts.back());
    }
    CHECK(bytes(all) == sum);
    size_t texel = 0;
    for (const ClusterTexels& part : parts)
        for (size_t k = 0; k < part.rows.row.size(); ++k, ++texel)
            for (float depth = -0.1f; depth < 1.2f; depth += 0.05f)
                CHECK(transmittance(all, texel, depth) == transmittance(part, k, depth));
}

TEST_CASE("one channel and three agree where the three are equal") {
    std::vector<TestTexel> fragments = random_texels(29, 10, 50, 0, 1, 0.2f);
    for (TestTexel& texel : fragments)
        for (TestFragment& fragment : texel) fragment.opacity = Rgb(fragment.opacity.x);
    // To the bit: three times a single precision depth, and a third of that, are exact in double.
    const ClusterTexels one = clusters(tile_of(fragments, 1), 4), three = clusters(tile_of(fragments, 3), 4);
    for (size_t texel = 0; texel < fragments.size(); ++texel)
        for (float depth = 0; depth < 1.1f; depth += 0.01f)
            CHECK(transmittance(one, texel, depth) == transmittance(three, texel, depth));
}
