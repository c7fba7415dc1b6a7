// SPDX-License-Identifier: MIT
#include "gather/lamp_visibility.h"

#include <doctest/doctest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "core/rng.h"
#include "gather/connection.h"
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
    if (getenv("RES")) options.maps.resolution = atoi(getenv("RES"));
    if (getenv("NEAR")) options.maps.near = atof(getenv("NEAR"));
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
            to.add(at, sample.direction, short_of(at, sample.distance), excluded, 0, u, segment);
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

}  // namespace

TEST_CASE("maps agree with rays wherever the lamp is") {
    const DVec3 at_a_point = [] {
        const Lit l = lit({ball()}, {}, PointLight{{0, 0, 9}, Rgb(1)}, by_maps(MapKind::deep));
        return DVec3(l.prepared.segments.start(uint32_t(l.prepared.segments.size() / 2))) + l.scene.origin;
    }();
    const struct {
        std::string name;
        Light lamp;
    } cases[] = {{"above", PointLight{{0, 6, 0}, Rgb(1)}},
                 {"below", PointLight{{0, -6, 0}, Rgb(1)}},
                 {"inside", PointLight{{0.1, 0.05, -0.1}, Rgb(1)}},
                 {"at the hair's rim", PointLight{{0.9, 0.2, 0}, Rgb(1)}},
                 {"at a hair point", PointLight{at_a_point, Rgb(1)}},
                 {"straight down", DistantLight{{0, -1, 0}, Rgb(1)}},
                 {"straight along z", DistantLight{{0, 0, -1}, Rgb(1)}},
                 {"far away", PointLight{{3e6, 4e6, 0}, Rgb(1)}},
                 {"a narrow spot", SpotLight{{0, 0, 6}, {0, 0, 0}, 14, Rgb(1)}},
                 {"a quad", QuadLight{{-2, -2, 5}, {{0, 4, 0}, {4, 0, 0}}, Rgb(1)}},
                 {"a quad among the hair", QuadLight{{-0.2, -0.2, 0.1}, {{0.4, 0, 0}, {0, 0.4, 0}}, Rgb(1)}}};
    for (const MapKind kind : kKinds)
        for (const auto& c : cases) {
            CAPTURE(int(kind));
            CAPTURE(c.name);
            const Lit l = lit({ball()}, {}, c.lamp, by_maps(kind));
            const Difference d = difference(l, 4);
            CAPTURE(d.absolute);
            CAPTURE(d.of_sign);
            MESSAGE(c.name, " ", int(kind), " ", d.absolute, " ", d.of_sign);
            CHECK(d.finite);
            CHECK(d.absolute < 0.02);
            CHECK(std::abs(d.of_sign) < 0.01);
        }
}
