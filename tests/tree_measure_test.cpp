// SPDX-License-Identifier: MIT
// Trees measured: figures that must not depend on the machine, and that time is kept on bad trees.
#include "gather/tree_measure.h"

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include <chrono>

#include "accel/build.h"
#include "accel/ray_work.h"
#include "tools/check/support/tree_scenes.h"

using namespace tress;
using namespace tress::scenes;

namespace {

TreeRays set_of(const char* name, HairQuery query, size_t n) {
    TreeRays set{name, query, {}};
    const Rays rays = mixed_rays(n, Vec3(0), 3);
    for (size_t i = 0; i < n; ++i)
        set.rays.add(Vec3(rays.ox[i], rays.oy[i], rays.oz[i]), Vec3(rays.dx[i], rays.dy[i], rays.dz[i]), kInfinity, {});
    return set;
}

AccelOptions one_leaf() {
    AccelOptions options;
    options.depth_base = options.depth_factor = 0;
    return options;
}

}  // namespace

TEST_CASE("every set that is not empty is traced and counted") {
    const Hair hair = clumped_hair(3000, 1);
    const std::vector<TreeRays> sets{set_of("primary", HairQuery::nearest, 2500), set_of("none", HairQuery::nearest, 0),
                                     set_of("gather", HairQuery::transmittance, 5000)};
    const TreeMeasure m = measure_tree(hair.view(), {}, sets, {}, 0.05);
    CHECK(m.build_seconds > 0);
    CHECK(m.statistics.leaves > 1);
    REQUIRE(m.rates.size() == 2);
    CHECK(m.rates[0].rays == "primary");
    CHECK(m.rates[0].query == "nearest");
    CHECK(m.rates[0].traced % 2500 == 0);
    CHECK(m.rates[0].counted == 2500);
    CHECK(m.rates[1].rays == "gather");
    CHECK(m.rates[1].query == "transmittance");
    for (const RayRate& rate : m.rates) {
        CHECK(rate.traced > 0);
        CHECK(rate.mrays_per_second > 0);
        CHECK(rate.steps > 1);
        CHECK(rate.tests > rate.leaves);
    }
}

TEST_CASE("work is the mean over the set, whatever the number of threads") {
    const Hair hair = clumped_hair(3000, 1);
    const TreeRays set = set_of("gather", HairQuery::transmittance, 1500);
    const KdTree tree = build_segment_tree(hair.view(), {});
    std::vector<uint32_t> crossings(1500);
    std::vector<RayWork> work(1500);
    count_transmittance_work(tree, set.rays.for_hair(), kMeasuredTransmission, kMeasuredCutoff, crossings, work,
                             Isa::automatic);
    RayWork sum;
    for (const RayWork& w : work) sum += w;
    for (const size_t threads : {1u, 3u}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const RayRate rate = measure_rays(tree, set, Isa::automatic, 0.4);
        CHECK(rate.counted == 1500);
        CHECK(rate.steps == double(sum.steps) / 1500);
        CHECK(rate.leaves == double(sum.leaves) / 1500);
        CHECK(rate.tests == double(sum.tests) / 1500);
    }
}

TEST_CASE("a tree that is far too slow for its rays still comes back in time") {
    const Hair hair = random_hair(200'000, 2);
    const KdTree tree = build_segment_tree(hair.view(), one_leaf());
    REQUIRE(tree.nodes.size() == 1);
    const TreeRays set = set_of("gather", HairQuery::transmittance, 100'000);  // some 20 s of tracing
    const auto start = std::chrono::steady_clock::now();
    const RayRate rate = measure_rays(tree, set, Isa::automatic, 0.1);
    CHECK(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < 2);  // 0.15, but for others
    CHECK(rate.traced > 0);
    CHECK(rate.traced < 100'000);
    CHECK(rate.steps == 0);
    if (rate.counted > 0) CHECK(rate.tests <= 200'000);
}
