// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include "accel/point_balls.h"
#include "core/rng.h"

using namespace tress;

namespace {

Vec3 random_point(uint64_t key, uint64_t i) {
    const float x = random(key, 3 * i), y = random(key, 3 * i + 1), z = random(key, 3 * i + 2);
    return {x, y, z};
}

struct PointSet {
    const char* name;
    std::vector<Vec3> points;
};

/// Random, on a plane, on a lattice (many ties), all the same, few, one and none.
std::vector<PointSet> point_sets() {
    std::vector<PointSet> sets = {{"random", {}}, {"plane", {}}, {"lattice", {}}, {"same", {}},
                                  {"few", {}},    {"one", {}},   {"none", {}}};
    for (uint64_t i = 0; i < 3000; ++i) {
        const Vec3 p = random_point(1, i);
        sets[0].points.push_back(p);
        sets[1].points.push_back({p.x, 0.5f, p.z});
        sets[2].points.push_back(floor(6.0f * p) / 6.0f);
        sets[3].points.push_back(Vec3(0.25f));
        if (i < 9) sets[4].points.push_back(p);
    }
    sets[5].points.push_back(Vec3(0.5f));
    return sets;
}

bool accepted(uint32_t id) { return id % 3 != 0; }

std::vector<float> brute_force_distances(const std::vector<Vec3>& points, const Vec3& p, size_t k, float radius) {
    std::vector<float> all;
    for (uint32_t i = 0; i < points.size(); ++i) {
        const float d2 = square(points[i].x - p.x) + square(points[i].y - p.y) + square(points[i].z - p.z);
        if (accepted(i) && d2 < square(radius)) all.push_back(d2);
    }
    std::sort(all.begin(), all.end());
    all.resize(std::min(all.size(), k));
    return all;
}

}  // namespace

TEST_CASE("the nearest points within a radius that a rule takes are those of brute force") {
    for (const PointSet& set : point_sets()) {
        CAPTURE(set.name);
        const PointTree tree = make_point_tree(set.points);
        REQUIRE(tree.size() == set.points.size());
        const auto accept = [&](uint32_t place, float) { return accepted(tree.id[place]); };
        std::vector<NearPoint> found;
        for (uint64_t q = 0; q < 200; ++q) {
            const bool at_a_point = q % 2 == 0 && !set.points.empty();
            const Vec3 p = at_a_point ? set.points[q % set.points.size()] : 1.4f * random_point(2, q) - 0.2f;
            for (const size_t k : {size_t(1), size_t(7), size_t(5000)}) {
                for (const float radius : {0.0f, 0.1f, kInfinity}) {
                    CAPTURE(q);
                    CAPTURE(k);
                    CAPTURE(radius);
                    const std::vector<float> expected = brute_force_distances(set.points, p, k, radius);
                    find_nearest(tree, p, k, radius, accept, found);
                    std::sort(found.begin(), found.end());
                    REQUIRE(found.size() == expected.size());
                    bool same = true;
                    for (size_t i = 0; i < found.size(); ++i) {
                        const Vec3& at = set.points[tree.id[found[i].place]];
                        same &= found[i].distance2 == expected[i] && at == tree.position(found[i].place);
                    }
                    CHECK(same);
                    if (k > 1) continue;
                    const uint32_t place = nearest_place(tree, p, radius, accept);
                    REQUIRE((place == kNowhere) == expected.empty());
                    if (place != kNowhere) CHECK(tree.distance2(p, place) == expected[0]);
                }
            }
        }
    }
}

TEST_CASE("every point is in the tree once, on its side of every split") {
    for (const PointSet& set : point_sets()) {
        CAPTURE(set.name);
        const PointTree tree = make_point_tree(set.points);
        std::vector<uint32_t> ids = tree.id;
        std::sort(ids.begin(), ids.end());
        for (uint32_t i = 0; i < ids.size(); ++i) REQUIRE(ids[i] == i);
        std::vector<std::pair<uint32_t, uint32_t>> ranges = {{0, uint32_t(tree.size())}};
        while (!ranges.empty()) {
            const auto [begin, end] = ranges.back();
            ranges.pop_back();
            if (end - begin <= PointTree::kLeafPoints) continue;
            const uint32_t middle = begin + (end - begin) / 2, axis = tree.axis[middle];
            const float split = tree.along(axis, middle);
            bool sides = true;
            for (uint32_t i = begin; i < middle; ++i) sides &= tree.along(axis, i) <= split;
            for (uint32_t i = middle + 1; i < end; ++i) sides &= tree.along(axis, i) >= split;
            REQUIRE(sides);
            ranges.push_back({begin, middle});
            ranges.push_back({middle + 1, end});
        }
    }
}

TEST_CASE("the point tree is the same for any number of threads") {
    std::vector<Vec3> points;
    for (uint64_t i = 0; i < 100'000; ++i) points.push_back(floor(40.0f * random_point(3, i)));
    const PointTree tree = make_point_tree(points);
    for (const size_t threads : {size_t(1), size_t(2), size_t(5)}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const PointTree again = make_point_tree(points);
        CHECK(again.id == tree.id);
        CHECK(again.axis == tree.axis);
    }
}

TEST_CASE("many equal points are searched no longer than many different ones") {
    const PointTree tree = make_point_tree(std::vector<Vec3>(200'000, Vec3(1)));
    size_t asked = 0;
    std::vector<NearPoint> found;
    find_nearest(
        tree, Vec3(1), 50, 1, [&](uint32_t, float) { return ++asked, true; }, found);
    CHECK(found.size() == 50);
    CHECK(asked == 50);
}

TEST_CASE("the balls that hold a point are those of brute force") {
    for (const PointSet& set : point_sets()) {
        CAPTURE(set.name);
        const PointTree tree = make_point_tree(set.points);
        std::vector<float> radius;
        for (uint64_t i = 0; i < tree.size(); ++i) radius.push_back(0.3f * square(square(random(4, i))));
        const PointBalls balls = make_point_balls(tree, radius);
        for (uint64_t q = 0; q < 200; ++q) {
            CAPTURE(q);
            const Vec3 p = random_point(2, q);
            std::vector<uint32_t> found, expected;
            visit_holding(tree, balls, p, [&](uint32_t place, float) { found.push_back(place); });
            for (uint32_t place = 0; place < tree.size(); ++place)
                if (tree.distance2(p, place) < square(radius[place])) expected.push_back(place);
            std::sort(found.begin(), found.end());
            CHECK(found == expected);
        }
    }
}
