// SPDX-License-Identifier: MIT
#include "gather/lamp_visibility.h"

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include "gather/crossing_light.h"
#include "gather/light_rays.h"
#include "gather/seen_points.h"
#include "tools/check/support/hair_lit_by_lamp.h"
#include "tools/check/support/turned_scene.h"

using namespace tress;
using namespace tress::test;

namespace {

constexpr MapKind kKinds[] = {MapKind::deep, MapKind::opacity, MapKind::clusters};

std::vector<PlacedLamp> lamps_everywhere() {
    std::vector<PlacedLamp> lamps = lamps_about_ball();
    lamps.push_back({"at a hair point", lamp_at_hair(ball(), 1000), true});
    return lamps;
}

}  // namespace

// The mean error of a point is of the order of what a shadow ray sees more or less at the rims of hair, 0.02 here; its
// mean over 400 points falls with the square root of their number, to 0.001. Fibers nearer to a lamp than their own
// width are not on its map: a lamp among the hair leaks half a percent.
TEST_CASE("deep maps agree with rays wherever the lamp is") {
    for (const PlacedLamp& placed : lamps_everywhere()) {
        CAPTURE(placed.name);
        const Options options = placed.among_hair ? by_maps(MapKind::deep) : fine_maps(MapKind::deep);
        const Difference d = difference(lit({ball()}, {}, placed.lamp, options), 4);
        CAPTURE(d.absolute);
        CAPTURE(d.of_sign);
        CHECK(d.finite);
        CHECK(d.absolute < 0.02);
        CHECK(std::abs(d.of_sign) < 0.008);
    }
}

// A quad is seen from four points alone, each over cells of a map that are wider than fibers.
TEST_CASE("from maps at a few of its points a quad is seen as by many rays to it") {
    const QuadLight quads[] = {{{-1, -1, 6}, {{0, 2, 0}, {2, 0, 0}}, Rgb(1)},
                               {{-0.2, -0.2, 0.1}, {{0, 0.4, 0}, {0.4, 0, 0}}, Rgb(1)}};
    for (const MapKind kind : kKinds)
        for (const QuadLight& quad : quads) {
            CAPTURE(int(kind));
            CAPTURE(quad.corner.z);
            const Difference d = difference(lit({ball()}, {}, quad, by_maps(kind)), 64);
            CAPTURE(d.absolute);
            CAPTURE(d.of_sign);
            CHECK(d.finite);
            CHECK(d.absolute < 0.04);
            CHECK(std::abs(d.of_sign) < 0.01);
        }
}

TEST_CASE("opacity maps and clusters agree with rays on average, wherever the lamp is") {
    for (const MapKind kind : {MapKind::opacity, MapKind::clusters})
        for (const PlacedLamp& placed : lamps_everywhere()) {
            CAPTURE(int(kind));
            CAPTURE(placed.name);
            const Difference d = difference(lit({ball()}, {}, placed.lamp, by_maps(kind)), 4);
            CAPTURE(d.of_sign);
            CHECK(d.finite);
            CHECK(std::abs(d.of_sign) < 0.02);
        }
}

TEST_CASE("rays that are traced all the way give what rays give, to the bit") {
    for (const MapKind kind : kKinds) {
        Options options = by_maps(kind);
        options.maps.near = 1e6f;
        const Lit l = lit({ball()}, {square(0.5f, Rgb(1))}, PointLight{{0, 1, 5}, Rgb(1)}, options);
        const LampRays to = ways(l, 2);
        CHECK(visibility(l, to, &maps_of(l), options.maps.near) == visibility(l, to, nullptr, 0));
    }
}

TEST_CASE("a polygon between stops all light, and points of polygons see quads by rays to the bit") {
    const QuadLight quad{{-2, -2, 5}, {{0, 4, 0}, {4, 0, 0}}, Rgb(1)};
    PlacedMesh between = square(3, Rgb(1));
    between.placement.m[11] = 2.5;
    const Lit blocked = lit({ball()}, {between}, PointLight{{0, 0, 5}, Rgb(1)}, by_maps(MapKind::deep));
    for (const Rgb& v : visibility(blocked, ways(blocked, 1), &maps_of(blocked), 4)) CHECK(v == Rgb(0));

    const Lit open = lit({ball()}, {}, quad, by_maps(MapKind::deep));
    LampRays to = ways(open, 2);
    for (uint32_t& segment : to.segment) segment = kNone;
    CHECK(visibility(open, to, &maps_of(open), 4) == visibility(open, to, nullptr, 0));
}

// Without rays next to the point a map shows a fiber to itself: what it stops of its own light is taken out on average.
// Of the 0.2 that it stops of a look-up here all but a twentieth is; a tenth where layers as thick as the fiber smear
// it.
TEST_CASE("a lone fiber does not shadow itself") {
    PlacedHair lone;
    lone.strands.constant_radius = 0.01f;
    lone.strands.first = {0, 65};
    for (int i = 0; i <= 64; ++i)
        lone.strands.add_point({0.03f * float(i) - 1, 0.02f * float(i) - 0.6f, 0.01f * float(i)});
    lone.fiber = fiber_with(Rgb(0.5f));
    for (const MapKind kind : kKinds)
        for (const float near : {0.0f, 4.0f}) {
            CAPTURE(int(kind));
            CAPTURE(near);
            Options options = by_maps(kind);
            options.maps.near = near;
            options.maps.resolution = 40;  // texels as wide as five fibers
            const Difference d = difference(lit({lone}, {}, PointLight{{0.3, 0.4, 6}, Rgb(1)}, options));
            CHECK(std::abs(d.of_sign) < (kind == MapKind::opacity ? 0.02 : 0.01));
        }
}

TEST_CASE("turning hair and lamp together changes the mean transmittance by less than a thousandth") {
    const Options options = fine_maps(MapKind::deep);
    const Lit upright = lit({ball()}, {}, PointLight{{1, 2, 5}, Rgb(1)}, options);
    for (uint64_t turn = 0; turn < 3; ++turn) {
        CAPTURE(turn);
        const Lit turned_about = lit(turned(upright.scene, random_turn(turn)), options);
        CHECK(std::abs(mean_visibility(turned_about) - mean_visibility(upright)) < 1e-3);
    }
}

TEST_CASE("maps are the same for any number of threads") {
    const QuadLight quad{{-2, -2, 5}, {{0, 4, 0}, {4, 0, 0}}, Rgb(1)};
    for (const MapKind kind : kKinds) {
        std::vector<Rgb> seen[2];
        for (const size_t threads : {1, 2}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            const Lit l = lit({ball()}, {}, quad, by_maps(kind));
            seen[threads - 1] = visibility(l, ways(l, 2), &maps_of(l), 1);
        }
        CHECK(seen[0] == seen[1]);
    }
}

TEST_CASE("ways to a quad lamp know where on it they end, from near and from far") {
    // Near, samples are uniform over the solid angle: the numbers they are made of are not places on the lamp.
    const double distances[] = {1.5, 30};
    for (const double distance : distances) {
        CAPTURE(distance);
        const QuadLight lamp{{-2, -2, distance}, {{0, 4, 0}, {4, 0, 0}}, Rgb(1)};
        const Lit l = lit({ball()}, {}, lamp, by_maps(MapKind::deep));
        const std::vector<ShadingPoint> points = find_seen_points(l.scene, l.prepared, l.options).hair;
        std::vector<Sampler> samplers;
        for (uint64_t i = 0; i < points.size(); ++i) samplers.push_back({hash(1, i), 0});
        LightRays ways;
        make_light_rays(l.scene, l.prepared, 0, 2, points, samplers, ways);
        REQUIRE(ways.size() > 100);
        const auto& quad = std::get<QuadLight>(l.scene.lights[0]);
        for (size_t i = 0; i < ways.size(); ++i) {
            const RayBuffer& rays = ways.to.rays;
            const DVec3 end = DVec3(rays.origin(i)) + double(rays.far(i)) * DVec3(rays.direction(i));
            const Vec2 place = ways.to.place[i];
            const DVec3 there = quad.corner + double(place.x) * quad.edge[0] + double(place.y) * quad.edge[1];
            // Rays stop short of the lamp by 32 ulps; directions are rounded to half a one each.
            CHECK(length(end - there) < 1e-4 * distance);
        }
    }
}
