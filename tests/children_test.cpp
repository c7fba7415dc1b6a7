// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include <limits>

#include "core/error.h"
#include "core/groom.h"
#include "core/hair_noise.h"

using namespace tress;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Two guides: a coil of 40 points, and a straight one of 2.
StrandSet guides() {
    StrandSet set;
    set.first = {0};
    for (int i = 0; i < 40; ++i) {
        const float angle = 0.5f * float(i);
        set.add_point({std::cos(angle), -0.3f * float(i), std::sin(angle)});
    }
    set.first.push_back(uint32_t(set.points()));
    set.add_point({10, 0, 0});
    set.add_point({10, -8, 0});
    set.first.push_back(uint32_t(set.points()));
    for (size_t p = 0; p < set.points(); ++p) {
        set.radius.push_back(0.004f - 0.00005f * float(p));
        set.color.push_back(Rgb(0.01f * float(p)));
    }
    return set;
}

}  // namespace

TEST_CASE("a count of 0 or 1 gives back the guides") {
    const StrandSet set = guides();
    for (const int count : {-3, 0, 1}) {
        const StrandSet same = grow_children(set, count, 0.3, 1);
        CHECK(same.x == set.x);
        CHECK(same.first == set.first);
    }
    CHECK(grow_children({}, 5, 0.3, 1).strands() == 0);
}

TEST_CASE("each guide gets its children, of as many points, with its radii and colours, the guide first") {
    const StrandSet set = guides();
    const int count = 7;
    const StrandSet grown = grow_children(set, count, 0.3, 1);
    REQUIRE(grown.strands() == set.strands() * count);
    REQUIRE(grown.points() == set.points() * count);
    CHECK(grown.first.back() == grown.points());
    for (size_t s = 0; s < grown.strands(); ++s) {
        const size_t guide = s / count;
        const uint32_t size = set.first[guide + 1] - set.first[guide];
        REQUIRE(grown.first[s + 1] - grown.first[s] == size);
        for (uint32_t i = 0; i < size; ++i) {
            const uint32_t p = grown.first[s] + i, g = set.first[guide] + i;
            REQUIRE(grown.radius[p] == set.radius[g]);
            REQUIRE(grown.color[p] == set.color[g]);
            if (s % count == 0) REQUIRE(grown.point(p) == set.point(g));
        }
    }
}

TEST_CASE("children root within the spread, across the guide, and draw together towards the tip") {
    const double spread = 0.4;
    const int count = 400;
    const StrandSet set = guides(), grown = grow_children(set, count, spread, 2);
    for (size_t guide = 0; guide < set.strands(); ++guide) {
        const Vec3 root = set.point(set.first[guide]);
        const Vec3 along = normalize(set.point(set.first[guide] + 1) - root);
        double farthest = 0, root_sum = 0, tip_sum = 0;
        Vec3 tip_mean(0);
        for (size_t c = 1; c < count; ++c) tip_mean += grown.point(grown.first[guide * count + c + 1] - 1);
        tip_mean /= float(count - 1);
        for (size_t c = 1; c < count; ++c) {
            const Vec3 offset = grown.point(grown.first[guide * count + c]) - root;
            const Vec3 from_mean = grown.point(grown.first[guide * count + c + 1] - 1) - tip_mean;
            const Vec3 end = set.point(set.first[guide + 1] - 1) - set.point(set.first[guide + 1] - 2);
            farthest = glm::max(farthest, double(length(offset)));
            // Rounding of coordinates of up to 10: 10 x 2^-24 a component.
            REQUIRE(std::abs(dot(offset, along)) < 1e-5f);
            root_sum += double(length(offset));
            tip_sum += double(length(from_mean - dot(from_mean, normalize(end)) * normalize(end)));
        }
        // Uniform in a disc: 399 miss its outer 5 % of radius (a tenth of the area) with a chance of 1e-18.
        CHECK(farthest <= spread * (1 + 1e-5));
        CHECK(farthest > 0.95 * spread);
        if (guide == 1) CHECK(tip_sum < 0.75 * root_sum);  // 0.3 of the offset, and a quarter of the spread astray
    }
}

TEST_CASE("children are the same for any number of threads, and others for another seed") {
    const StrandSet set = guides(), grown = grow_children(set, 50, 0.3, 3);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    CHECK(grow_children(set, 50, 0.3, 3).x == grown.x);
    CHECK(grow_children(set, 50, 0.3, 4).x != grown.x);
}

TEST_CASE("guides with points that are not finite, all equal or turning back give children without harm") {
    StrandSet set;
    set.first = {0};
    const auto add = [&](std::initializer_list<Vec3> points) {
        for (const Vec3& p : points) set.add_point(p);
        set.first.push_back(uint32_t(set.points()));
    };
    add({{0, 0, 0}, {0, kNan, 0}, {0, -2, 0}, {0, -3, 0}, {0, -4, 0}, {0, -5, 0}, {0, -6, 0}});
    add({{kNan, kNan, kNan}, {kNan, kNan, kNan}});
    add({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}});
    add({{2, 0, 0}, {2, -1, 0}, {2, 0, 0}, {2, -1, 0}});
    add({{3e38f, 0, 0}, {-3e38f, 0, 0}});
    add({{1e-40f, 0, 0}, {0, 1e-40f, 0}});
    const StrandSet grown = grow_children(set, 9, 0.3, 5);
    REQUIRE(grown.points() == set.points() * 9);
    // Far from the bad point the first guide's children are whole.
    for (size_t c = 0; c < 9; ++c) CHECK(is_finite(grown.point(grown.first[c] + 6)));
    for (size_t s = 2 * 9; s < 4 * 9; ++s) {
        for (uint32_t p = grown.first[s]; p < grown.first[s + 1]; ++p) REQUIRE(is_finite(grown.point(p)));
    }
}

TEST_CASE("more children than point indices can count are refused before anything is allocated") {
    CHECK_THROWS_WITH_AS(grow_children(guides(), std::numeric_limits<int>::max(), 0.3, 0),
                         doctest::Contains("fewer than 2^32"), InputError);
}
