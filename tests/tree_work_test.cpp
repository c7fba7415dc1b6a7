// SPDX-License-Identifier: MIT
// The work of queries, counted: as reckoned by hand on small trees, the same on every instruction set.
#include <doctest/doctest.h>

#include "accel/build.h"
#include "accel/ray_work.h"
#include "tools/check/support/tree_scenes.h"

using namespace tress;
using namespace tress::scenes;

namespace {

struct NearestWork {
    Nearest hits;
    std::vector<RayWork> work;
};
NearestWork nearest_work(const KdTree& tree, const RayBatch& rays, Isa isa = Isa::automatic) {
    const size_t n = rays.size();
    NearestWork out{{std::vector<float>(n), std::vector<float>(n), std::vector<float>(n), std::vector<uint32_t>(n)},
                    std::vector<RayWork>(n, {9, 9, 9})};
    Nearest& h = out.hits;
    count_nearest_work(tree, rays, {h.t, h.id, h.u, h.h}, out.work, isa);
    return out;
}

struct CrossingWork {
    std::vector<uint32_t> crossings;
    std::vector<RayWork> work;
};
CrossingWork crossing_work(const KdTree& tree, const RayBatch& rays, float transmission, float cutoff,
                           Isa isa = Isa::automatic) {
    const size_t n = rays.size();
    CrossingWork out{std::vector<uint32_t>(n), std::vector<RayWork>(n, {9, 9, 9})};
    count_transmittance_work(tree, rays, transmission, cutoff, out.crossings, out.work, isa);
    return out;
}

/// Halves the longest side of cells down to `levels`, or to one reference.
KdTree halved(const Hair& hair, int levels) {
    AccelOptions options;
    options.split = SplitMethod::spatial_median;
    options.automatic = false;
    options.leaf_size = 1;
    options.depth_base = float(levels);
    options.depth_factor = 0;
    return build_segment_tree(hair.view(), options);
}

/// Short and upright, one at each x.
Hair fence(const std::vector<float>& at) {
    Hair hair;
    for (const float x : at) hair.add(Vec3(x, -0.5f, 0), Vec3(x, 0.5f, 0), 0.125f);
    return hair;
}

Rays along_x() {
    Rays rays;
    rays.add(Vec3(-10, 0, 0), Vec3(1, 0, 0));
    return rays;
}

}  // namespace

TEST_CASE("one leaf: no steps, and a test for each segment") {
    const KdTree tree = halved(random_hair(20, 1), 0);
    Rays rays;
    rays.add(Vec3(0, 0, 5), Vec3(0, 0, -1));
    rays.add(Vec3(0, 0, 5), Vec3(0, 0, 1));
    const std::vector<RayWork> expected{{0, 1, 20}, {0, 0, 0}};
    CHECK(nearest_work(tree, rays.batch()).work == expected);
    CHECK(crossing_work(tree, rays.batch(), 0.5f, 0).work == expected);
}

TEST_CASE("a ray ends where its query does") {
    const KdTree tree = halved(fence({-3, -1, 1, 3}), 2);  // cut at 0, then at -1.5 and 1.5
    REQUIRE(tree.nodes.size() == 7);
    const Rays rays = along_x();
    CHECK(nearest_work(tree, rays.batch()).work[0] == RayWork{2, 1, 1});
    CHECK(crossing_work(tree, rays.batch(), 0.5f, 0.6f).work[0] == RayWork{2, 1, 1});
    CHECK(crossing_work(tree, rays.batch(), 0.5f, 0.3f).work[0] == RayWork{2, 2, 2});
    CHECK(crossing_work(tree, rays.batch(), 0.5f, 0.2f).work[0] == RayWork{3, 3, 3});
    CHECK(crossing_work(tree, rays.batch(), 0.5f, 0).work[0] == RayWork{3, 4, 4});
}

TEST_CASE("a skipped segment is tested, and a leaf that a ray does not touch is not") {
    const KdTree tree = halved(fence({-3, -1, 1, 3}), 2);
    Rays rays = along_x();
    rays.skip_first = rays.skip_last = {0};
    CHECK(nearest_work(tree, rays.batch()).work[0] == RayWork{2, 2, 2});
    Rays down;
    down.add(Vec3(3, 5, 0), Vec3(0, -1, 0));
    CHECK(crossing_work(tree, down.batch(), 0.5f, 0).work[0] == RayWork{2, 1, 1});
}

TEST_CASE("empty leaves are no work") {
    const KdTree tree = halved(fence({-4, -4, 4}), 2);  // cut at 0, then at -2: nothing is beyond
    REQUIRE(tree.nodes.size() == 5);
    CHECK(crossing_work(tree, along_x().batch(), 0.5f, 0).work[0] == RayWork{2, 2, 3});
}

TEST_CASE("an empty tree is no work") {
    const KdTree tree = build_segment_tree(SegmentView{}, AccelOptions{});
    CHECK(nearest_work(tree, along_x().batch()).work[0] == RayWork{});
    CHECK(crossing_work(tree, along_x().batch(), 0.5f, 0).work[0] == RayWork{});
}

TEST_CASE("counting changes no answer, and no instruction set, nor batch, changes a count") {
    for (const bool linked : {false, true}) {
        CAPTURE(linked);
        const Hair hair = linked ? strands(300, 10, 5) : random_hair(3000, 5, true);
        const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
        const Rays rays = mixed_rays(3000, Vec3(0), 6);
        const RayBatch batch = rays.batch();
        const NearestWork near = nearest_work(tree, batch, Isa::scalar);
        const CrossingWork through = crossing_work(tree, batch, 0.7f, 1e-3f, Isa::scalar);
        CHECK(near.hits == nearest(tree, batch, Isa::scalar));
        CHECK(through.crossings == constant(tree, batch, 0.7f, 1e-3f, Isa::scalar).crossings);
        for (const Isa isa : supported_isas()) {
            CAPTURE(int(isa));
            const NearestWork other_near = nearest_work(tree, batch, isa);
            const CrossingWork other_through = crossing_work(tree, batch, 0.7f, 1e-3f, isa);
            CHECK(other_near.hits == near.hits);
            CHECK(other_near.work == near.work);
            CHECK(other_through.crossings == through.crossings);
            CHECK(other_through.work == through.work);
        }
        const NearestWork part = nearest_work(tree, batch.part(1000, 500));
        CHECK(std::equal(part.work.begin(), part.work.end(), near.work.begin() + 1000));
        CHECK(part.hits.id == std::vector<uint32_t>(near.hits.id.begin() + 1000, near.hits.id.begin() + 1500));
    }
}

TEST_CASE("no ray works more where its cutoff is higher") {
    const KdTree tree = build_segment_tree(clumped_hair(3000, 9).view(), AccelOptions{});
    const Rays rays = mixed_rays(2000, Vec3(0), 10);
    const CrossingWork all = crossing_work(tree, rays.batch(), 0.7f, 0),
                       some = crossing_work(tree, rays.batch(), 0.7f, 0.2f);
    RayWork sum_all, sum_some;
    for (size_t i = 0; i < rays.size(); ++i) {
        CHECK(some.work[i].tests <= all.work[i].tests);
        CHECK(some.work[i].steps <= all.work[i].steps);
        sum_all += all.work[i], sum_some += some.work[i];
    }
    CHECK(sum_some.tests < sum_all.tests);
}
