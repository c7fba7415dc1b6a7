// SPDX-License-Identifier: MIT
#include "gather/lamp_visibility.h"

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include "core/rng.h"
#include "gather/connection.h"
#include "gather/crossing_light.h"
#include "gather/light_rays.h"
#include "gather/seen_points.h"
#include "tests/tufts.h"

using namespace tress;
using namespace tress::test;

namespace {

constexpr size_t kPoints = 400;
constexpr MapKind kKinds[] = {MapKind::deep, MapKind::opacity, MapKind::clusters};
constexpr LampMethod kMethods[] = {LampMethod::deep, LampMethod::opacity, LampMethod::clusters};

Options by_maps(MapKind kind) {
    Options options = small_options();
    options.type1 = kMethods[size_t(kind)];
    options.type2 = GatherMethod::off;
    options.type3 = CrossingMethod::off;
    return options;
}

/// A ball of two thousand fibers, a unit wide, with as many crossings on a way through its middle as on a head's rim.
PlacedHair ball(const Vec3& center = Vec3(0)) {
    return ball_of_hair(2000, 4, 1, 0.008f, center, 7, fiber_with(sigma_a_from_melanin(0.6f, 0.2f)));
}

struct Lit {
    Scene scene;
    Plan plan;
    PreparedScene prepared;
    Options options;
};

Lit lit(std::vector<PlacedHair> hair, std::vector<PlacedMesh> meshes, const Light& lamp, const Options& options) {
    Lit l{assemble(std::move(hair), std::move(meshes), {lamp}, camera_on_z(8, 32, 32)), {}, {}, options};
    l.plan = make_plan(l.scene, options);
    l.prepared = prepare(l.scene, l.plan, options);
    return l;
}

/// Ways to the lamp from points that it lights, on axes of fibers all over the hair; `samples` a point, over its area.
LampRays ways(const Lit& l, int samples) {
    const SegmentView& hair = l.prepared.segments;
    LampRays to;
    for (size_t i = 0; i < kPoints; ++i) {
        const uint32_t segment = uint32_t(tress::random(1, i) * float(hair.size()));
        const Vec3 at = mix(hair.start(segment), hair.end(segment), tress::random(2, i));
        Excluded excluded;
        excluded.segments = own_strand(hair, segment);
        for (int s = 0; s < samples; ++s) {
            const float v = tress::random(3, i * 64 + size_t(s));
            const Vec2 u((float(s) + 0.5f) / float(samples), v);
            const LightSample sample = sample_lamp(l.scene.lights[0], at, u);
            if (!(max_component(sample.irradiance) > 0)) break;
            to.add(at, sample.direction, short_of(at, sample.distance), excluded, 0, sample.place, segment);
        }
    }
    return to;
}

struct Difference {
    double absolute = 0, of_sign = 0;
    bool finite = true;
};

std::vector<Rgb> visibility(const Lit& l, const LampRays& to, const LampMaps* maps, float near) {
    std::vector<Rgb> v(to.size());
    LampVisibility()(l.scene, l.prepared, maps, near, l.options, to, v);
    return v;
}

const LampMaps& maps_of(const Lit& l) { return l.prepared.shadow_maps[size_t(*l.plan.lamp_maps)]; }

/// Of maps from rays, mean over points; of each point the mean over the lamp.
Difference difference(const Lit& l, int samples = 1) {
    const LampRays to = ways(l, samples);
    const std::vector<Rgb> by_map = visibility(l, to, &maps_of(l), l.options.maps.near);
    const std::vector<Rgb> by_ray = visibility(l, to, nullptr, 0);
    Difference d;
    for (size_t first = 0; first < to.size(); first += size_t(samples)) {
        double sum = 0;
        for (size_t i = first; i < first + size_t(samples); ++i) {
            sum += double(mean(by_map[i]) - mean(by_ray[i])) / samples;
            d.finite &= is_finite(by_map[i]) && min_component(by_map[i]) >= 0 && max_component(by_map[i]) <= 1;
        }
        d.absolute += std::abs(sum);
        d.of_sign += sum;
    }
    d.absolute /= double(to.size()) / samples;
    d.of_sign /= double(to.size()) / samples;
    return d;
}

/// Maps that resolve the fibers of the ball: then nothing is left but what texels at their rims confuse.
Options fine_maps(MapKind kind) {
    Options options = by_maps(kind);
    options.maps.resolution = 1024;
    return options;
}

struct PlacedLamp {
    std::string name;
    Light lamp;
    bool among_hair = false;  // whole cube faces, on which fibers are wide as they are
};

std::vector<PlacedLamp> lamps_everywhere() {
    const Lit any = lit({ball()}, {}, PointLight{{0, 0, 9}, Rgb(1)}, by_maps(MapKind::deep));
    const SegmentView& hair = any.prepared.segments;
    const DVec3 at_a_point = DVec3(hair.start(uint32_t(hair.size() / 2))) + any.scene.origin;
    return {{"above", PointLight{{0, 6, 0}, Rgb(1)}},
            {"below", PointLight{{0, -6, 0}, Rgb(1)}},
            {"inside", PointLight{{0.1, 0.05, -0.1}, Rgb(1)}, true},
            {"at the hair's rim", PointLight{{0.9, 0.2, 0}, Rgb(1)}, true},
            {"at a hair point", PointLight{at_a_point, Rgb(1)}, true},
            {"straight down", DistantLight{{0, -1, 0}, Rgb(1)}},
            {"straight along z", DistantLight{{0, 0, -1}, Rgb(1)}},
            {"far away", PointLight{{3e6, 4e6, 0}, Rgb(1)}},
            {"a narrow spot", SpotLight{{0, 0, 6}, {0, 0, 0}, 14, Rgb(1)}}};
}

/// About the origin, by an angle about an axis.
glm::dmat3 rotation(const DVec3& axis, double angle) {
    const DVec3 a = normalize(axis);
    const double c = std::cos(angle), s = std::sin(angle);
    glm::dmat3 m;
    for (int column = 0; column < 3; ++column) {
        DVec3 e(0);
        e[column] = 1;
        m[column] = c * e + s * cross(a, e) + (1 - c) * dot(a, e) * a;
    }
    return m;
}

PlacedHair rotated(PlacedHair hair, const glm::dmat3& by) {
    for (size_t i = 0; i < hair.strands.points(); ++i) {
        const DVec3 p = by * DVec3(hair.strands.point(i));
        hair.strands.x[i] = float(p.x), hair.strands.y[i] = float(p.y), hair.strands.z[i] = float(p.z);
    }
    return hair;
}

double mean_visibility(const Lit& l) {
    const LampRays to = ways(l, 4);
    double sum = 0;
    for (const Rgb& v : visibility(l, to, &maps_of(l), l.options.maps.near)) sum += double(mean(v));
    return sum / double(to.size());
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
    const PointLight lamp{{1, 2, 5}, Rgb(1)};
    const double upright = mean_visibility(lit({ball()}, {}, lamp, fine_maps(MapKind::deep)));
    for (const DVec3& axis : {DVec3(0, 0, 1), DVec3(1, 2, 3), DVec3(-3, 1, 0.5)}) {
        const glm::dmat3 turn = rotation(axis, 1.1);
        const Lit turned =
            lit({rotated(ball(), turn)}, {}, PointLight{turn * lamp.position, Rgb(1)}, fine_maps(MapKind::deep));
        CHECK(std::abs(mean_visibility(turned) - upright) < 1e-3);
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
        const std::vector<ShadingPoint> points = find_seen_points(l.scene, l.prepared, l.options);
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
