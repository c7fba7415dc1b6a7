// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/light_view.h"

#include <doctest/doctest.h>

#include <vector>

#include "core/rng.h"

using namespace tress;

namespace {

constexpr int kViews = 200, kPoints = 50;

/// Uniform in [-1, 1]^3.
DVec3 anywhere(uint64_t key) {
    DVec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = 2 * double(random(key, uint64_t(axis))) - 1;
    return p;
}

/// About (0, 0, 0), which it sees; from up to `far` away.
LightView some_view(uint64_t key, bool parallel, double far) {
    LightView view;
    const DVec3 way = normalize(anywhere(key));
    view.origin = -way * (far * (0.1 + 0.9 * double(random(key, 3))));
    view.frame = frame_about(Vec3(way));
    view.parallel = parallel;
    view.start = 0.05 * far * double(random(key, 4));
    view.low = {-1.5, -1};
    view.texel = glm::dvec2(2.0 / 512);
    view.width = 512;
    view.height = 400;
    return view;
}

/// Where light through a place of the view is at a depth.
DVec3 back_projected(const LightView& view, const ViewPoint& at) {
    const DVec3 z(view.frame.z), along(light_direction(view, at.x, at.y));
    const double deep = double(at.depth) + view.start;
    if (!view.parallel) return view.origin + along * (deep / dot(along, z));
    const glm::dvec2 across = view.low + glm::dvec2(double(at.x), double(at.y)) * view.texel;
    return view.origin + across.x * DVec3(view.frame.x) + across.y * DVec3(view.frame.y) + deep * along;
}

bool same(const ViewPoint& a, const ViewPoint& b, float tolerance) {
    return std::abs(a.x - b.x) <= tolerance && std::abs(a.y - b.y) <= tolerance;
}

}  // namespace

TEST_CASE("a point comes back from its place in a view along the light's direction") {
    for (const bool parallel : {false, true}) {
        for (uint64_t v = 0; v < kViews; ++v) {
            const LightView view = some_view(v, parallel, 10);
            for (uint64_t i = 0; i < kPoints; ++i) {
                const Vec3 p(0.5 * anywhere(hash(v, i)));
                const ViewPoint at = project(view, p);
                CAPTURE(parallel);
                CAPTURE(v);
                CAPTURE(i);
                REQUIRE(at.in_front);
                // A coordinate of up to 512 texels of 1/256, the depth and the direction are each rounded by up to
                // 2^-24 of the distance (or more across, at a slant of up to 60 degrees: twice); axes of a frame in
                // float are orthonormal to within 4 of those. A dozen of them at most.
                const double reach = parallel ? 12 : length(DVec3(p) - view.origin) + 1;
                CHECK(distance(back_projected(view, at), DVec3(p)) <= 16 * 0x1p-24 * reach);
            }
        }
    }
}

TEST_CASE("light that goes straight on stays at one place of a view") {
    for (const bool parallel : {false, true}) {
        for (uint64_t v = 0; v < kViews; ++v) {
            const LightView view = some_view(v, parallel, 10);
            const ViewPoint at{float(512 * double(random(v, 9))), float(400 * double(random(v, 10))), 0, true};
            const Vec3 along = light_direction(view, at.x, at.y);
            CHECK(double(glm::length(along)) == doctest::Approx(1).epsilon(1e-6));
            const Vec3 start(back_projected(view, at));
            for (const float far : {0.1f, 1.0f, 10.0f}) {
                CAPTURE(parallel);
                CAPTURE(v);
                CAPTURE(far);
                // Points of up to 40 units, rounded to float, are at least 1 from the origin: 40 ulp across, as texels
                // of 1/256, and slanted by up to 60 degrees: four times that.
                CHECK(same(project(view, start + far * along), at, 256 * 4 * 40 * 0x1p-24f));
            }
        }
    }
}

TEST_CASE("a texel is as wide as what falls into it") {
    for (const bool parallel : {false, true}) {
        for (uint64_t v = 0; v < kViews; ++v) {
            const LightView view = some_view(v, parallel, 10);
            const float depth = 5 * random(v, 11);
            const DVec3 a = back_projected(view, {100, 100, depth, true});
            const DVec3 b = back_projected(view, {101, 100, depth, true});
            CAPTURE(parallel);
            CAPTURE(v);
            // Rounding of a direction, as a share of a texel of 1/256 of the distance: 256 x 4 ulp.
            CHECK(double(texel_width(view, depth)) == doctest::Approx(distance(a, b)).epsilon(256 * 8 * 0x1p-24));
        }
    }
}

TEST_CASE("the longer side of a texel counts, and none is negative") {
    LightView view = some_view(0, false, 10);
    view.texel = {0.25, 0.5};
    view.start = 4;
    CHECK(texel_width(view, -3) == 0.5f);
    CHECK(texel_width(view, 0) == 2);
    CHECK(texel_width(view, 4) == 4);
    CHECK(texel_width(view, -4) == 0);
    CHECK(texel_width(view, -1000) == 0);
    view.parallel = true;
    for (const float depth : {-1000.0f, 0.0f, 7.0f}) CHECK(texel_width(view, depth) == 0.5f);
}

TEST_CASE("nothing at or behind a pinhole is in its view, and a parallel view has no behind") {
    for (uint64_t v = 0; v < kViews; ++v) {
        LightView view = some_view(v, false, 10);
        view.origin = round(view.origin * 1024.0) / 1024.0;  // so that it is one in float
        const Vec3 origin(view.origin);
        CAPTURE(v);
        CHECK(!project(view, origin).in_front);
        CHECK(!contains(view, project(view, origin - 0.1f * view.frame.z)));
        CHECK(!project(view, origin - 1e6f * view.frame.z + view.frame.x).in_front);
        view.parallel = true;
        CHECK(project(view, origin - 1e6f * view.frame.z).in_front);
    }
}

TEST_CASE("places far outside a view are finite and outside") {
    LightView view = some_view(0, false, 10);
    view.frame = frame_about({0, 0, 1});
    view.origin = {0, 0, 0};
    for (const Vec3& p : {Vec3(1, 0, 1e-30f), Vec3(0, -1e30f, 1e-38f), Vec3(1e38f, 1e38f, 1e-38f)}) {
        const ViewPoint at = project(view, p);
        CHECK(at.in_front);
        CHECK(is_finite({at.x, at.y, at.depth}));
        CHECK(!contains(view, at));
    }
}

TEST_CASE("of two views side by side one contains a point near their border") {
    LightView left = some_view(0, false, 10);
    left.frame = frame_about({0, 0, 1});
    left.origin = {0, 0, 0};
    left.low = {-1, -1};
    left.texel = glm::dvec2(1.0 / 256);
    left.width = left.height = 256;
    LightView right = left;
    right.low.x = 0;
    for (const float x : {-1e-3f, -1e-6f, -1e-9f, -1e-15f, 0.0f, 1e-15f, 1e-9f, 1e-6f, 1e-3f}) {
        const Vec3 p(x, -0.5f, 1);
        CAPTURE(x);
        CHECK(contains(left, project(left, p)) == (x < 0));
        CHECK(contains(right, project(right, p)) == (x >= 0));
    }
}

TEST_CASE("texels of a view have places of their own, tile by tile") {
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(32, 33), std::pair(100, 70), std::pair(512, 1)}) {
        LightView view;
        view.width = width;
        view.height = height;
        std::vector<int> taken(size_t(tile_count(view)) * kViewTile * kViewTile, 0);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const size_t place = texel_index(view, x, y);
                REQUIRE(place < taken.size());
                CHECK(++taken[place] == 1);
                CHECK(place / (kViewTile * kViewTile) == size_t(y / kViewTile * tiles_across(view) + x / kViewTile));
            }
        }
    }
}
