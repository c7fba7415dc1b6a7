// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include "core/light_sample.h"
#include "core/rng.h"
#include "gather/shadow_maps/fit_views.h"

using namespace tress;

TEST_CASE("points of a quad lie one in each cell, in rows and columns of their own") {
    const QuadLight light{{1, 2, 3}, {{2, 0, 0}, {0, 0, 4}}, Rgb(1)};
    for (const int grid : {1, 2, 3, 5}) {
        const std::vector<DVec3> points = view_points(light, grid);
        const size_t n = size_t(grid) * size_t(grid);
        REQUIRE(points.size() == n);
        std::vector<int> column(n, 0), row(n, 0);
        for (size_t i = 0; i < n; ++i) {
            const double x = (points[i].x - 1) / 2, y = (points[i].z - 3) / 4;
            CAPTURE(grid);
            CAPTURE(i);
            CHECK(view_point_of(light, grid, {float(x), float(y)}) == i);
            CHECK(++column[size_t(x * double(n))] == 1);
            CHECK(++row[size_t(y * double(n))] == 1);
        }
    }
}

TEST_CASE("a sample of a quad belongs to a point of its own cell") {
    const QuadLight light{{-1, 4, 0}, {{2, 0, 0}, {0, 0.5, 1}}, Rgb(1)};
    constexpr int grid = 3;
    const std::vector<DVec3> points = view_points(light, grid);
    const Vec3 from(0.3f, -1, 0.2f);
    for (uint64_t key = 0; key < 1000; ++key) {
        const float x = random(key, 0), y = random(key, 1);
        const LightSample s = sample(light, from, {x, y});
        const DVec3 place = DVec3(from) + double(s.distance) * DVec3(s.direction);
        const DVec3 apart = place - points[view_point_of(light, grid, {x, y})];
        // Within one cell: less than its sides apart; rounding of a direction at a distance of 5.
        CHECK(std::abs(apart.x) <= 2.0 / grid + 1e-5);
        CHECK(std::abs(apart.z) <= 1.0 / grid + 1e-5);
    }
    CHECK(view_point_of(light, grid, {0, 0}) == 0);
    CHECK(view_point_of(light, grid, {0x1.fffffep-1f, 0}) == 2);
    CHECK(view_point_of(light, grid, {0, 0x1.fffffep-1f}) == 6);
    CHECK(view_points(PointLight{{1, 2, 3}}, 4) == std::vector<DVec3>{{1, 2, 3}});
    CHECK(view_point_of(PointLight{}, 4, {0.9f, 0.9f}) == 0);
}
