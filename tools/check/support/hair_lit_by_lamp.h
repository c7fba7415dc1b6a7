// SPDX-License-Identifier: MIT
// Hair lit by a lamp from everywhere, and what shadow maps say of the ways to it against what rays say.
#pragma once

#include <string>

#include "core/rng.h"
#include "gather/connection.h"
#include "gather/lamp_visibility.h"
#include "tools/check/support/tufts.h"

namespace tress::test {

inline constexpr size_t kPoints = 400;
inline constexpr LampMethod kMethods[] = {LampMethod::deep, LampMethod::opacity, LampMethod::clusters};

inline Options by_maps(MapKind kind) {
    Options options = small_options();
    options.type1 = kMethods[size_t(kind)];
    options.type2 = GatherMethod::off;
    options.type3 = CrossingMethod::off;
    return options;
}

/// A ball of two thousand fibers, a unit wide, with as many crossings on a way through its middle as on a head's rim.
inline PlacedHair ball(const Vec3& center = Vec3(0)) {
    return ball_of_hair(2000, 4, 1, 0.008f, center, 7, fiber_with(sigma_a_from_melanin(0.6f, 0.2f)));
}

/// The same of few and fair fibers: from its middle its optical depth is about 1.
inline PlacedHair fair_ball(const Vec3& center = Vec3(0)) {
    return ball_of_hair(300, 4, 1, 0.008f, center, 7, fiber_with(sigma_a_from_melanin(0.05f, 0.2f)));
}

struct Lit {
    Scene scene;
    Plan plan;
    PreparedScene prepared;
    Options options;
};

inline Lit lit(Scene scene, const Options& options) {
    Lit l{std::move(scene), {}, {}, options};
    l.plan = make_plan(l.scene, options);
    l.prepared = prepare(l.scene, l.plan, options);
    return l;
}

inline Lit lit(std::vector<PlacedHair> hair, std::vector<PlacedMesh> meshes, const Light& lamp,
               const Options& options) {
    return lit(assemble(std::move(hair), std::move(meshes), {lamp}, camera_on_z(8, 32, 32)), options);
}

/// Ways to the lamp from points that it lights, on axes of fibers all over the hair; `samples` a point, over its area.
inline LampRays ways(const Lit& l, int samples, size_t points = kPoints) {
    const SegmentView& hair = l.prepared.segments;
    LampRays to;
    for (size_t i = 0; i < points; ++i) {
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

inline std::vector<Rgb> visibility(const Lit& l, const LampRays& to, const LampMaps* maps, float near) {
    std::vector<Rgb> v(to.size());
    LampVisibility()(l.scene, l.prepared, maps, near, l.options, to, v);
    return v;
}

inline const LampMaps& maps_of(const Lit& l) { return l.prepared.shadow_maps[size_t(*l.plan.lamp_maps)]; }

/// Of maps from rays, mean over points; of each point the mean over the lamp.
inline Difference difference(const Lit& l, int samples = 1) {
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
inline Options fine_maps(MapKind kind) {
    Options options = by_maps(kind);
    options.maps.resolution = 1024;
    return options;
}

struct PlacedLamp {
    std::string name;
    Light lamp;
    bool among_hair = false;  // whole cube faces, on which fibers are wide as they are
};

/// About a ball of hair at the origin, a unit wide.
inline std::vector<PlacedLamp> lamps_about_ball() {
    return {{"above", PointLight{{0, 6, 0}, Rgb(1)}},
            {"below", PointLight{{0, -6, 0}, Rgb(1)}},
            {"inside", PointLight{{0.1, 0.05, -0.1}, Rgb(1)}, true},
            {"at the hair's rim", PointLight{{0.9, 0.2, 0}, Rgb(1)}, true},
            {"straight down", DistantLight{{0, -1, 0}, Rgb(1)}},
            {"straight along z", DistantLight{{0, 0, -1}, Rgb(1)}},
            {"far away", PointLight{{3e6, 4e6, 0}, Rgb(1)}},
            {"a narrow spot", SpotLight{{0, 0, 6}, {0, 0, 0}, 14, Rgb(1)}}};
}

/// On the axis of a strand, in the midst of it.
inline PointLight lamp_at_hair(const PlacedHair& hair, size_t strand) {
    return {DVec3(hair.strands.point(hair.strands.first[strand] + 2)), Rgb(1)};
}

/// Single ways differ by 0.02 from what rays say: of so many the mean is known to 2e-4.
inline double mean_visibility(const Lit& l) {
    constexpr size_t kWays = 20'000;
    const LampRays to = ways(l, 1, kWays);
    double sum = 0;
    for (const Rgb& v : visibility(l, to, &maps_of(l), l.options.maps.near)) sum += double(mean(v));
    return sum / double(to.size());
}

}  // namespace tress::test
