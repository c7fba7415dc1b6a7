// SPDX-License-Identifier: MIT
// Hair thick enough for all types of light, and few strands of it.
#pragma once

#include "core/rng.h"
#include "tools/check/support/scene_parts.h"
#include "tools/check/support/small_scenes.h"

namespace tress::test {

inline constexpr uint32_t kBlonde = 0, kDark = 1;

/// Strands of a few segments, bent at random, within a ball about `center`.
inline PlacedHair ball_of_hair(int strands, int segments, double ball, float radius, const Vec3& center, uint64_t seed,
                               const Fiber& fiber) {
    PlacedHair hair;
    hair.fiber = fiber;
    hair.strands.constant_radius = radius;
    hair.strands.first = {0};
    for (int s = 0; s < strands; ++s) {
        const uint64_t key = hash(seed, uint64_t(s));
        uint64_t drawn = 0;
        const auto within = [&](double size) {
            Vec3 p;
            for (int axis = 0; axis < 3; ++axis) p[axis] = float(size * (2 * double(tress::random(key, drawn++)) - 1));
            return p;
        };
        Vec3 p = within(0.6 * ball);
        const Vec3 along = normalize(within(1)) * float(1.6 * ball / segments);
        p -= along * (0.5f * float(segments));
        for (int i = 0; i <= segments; ++i) {
            hair.strands.add_point(center + p);
            p += along + within(0.3 * ball / segments);
        }
        hair.strands.first.push_back(uint32_t(hair.strands.points()));
    }
    return hair;
}

inline Fiber fiber_with(const Rgb& sigma_a, float alpha_degrees = FiberParameters{}.alpha_degrees) {
    FiberParameters parameters;
    parameters.sigma_a = sigma_a;
    parameters.alpha_degrees = alpha_degrees;
    return make_fiber(parameters);
}

/// Blonde hair, and dark hair beside it.
inline std::vector<PlacedHair> two_balls(float alpha_degrees = FiberParameters{}.alpha_degrees) {
    const auto ball = [&](float x, uint64_t seed, const Rgb& sigma_a) {
        return ball_of_hair(120, 3, 0.7, 0.03f, {x, 0, 0}, seed, fiber_with(sigma_a, alpha_degrees));
    };
    return {ball(-0.8f, 1, sigma_a_from_melanin(0.2f, 0.1f)), ball(0.8f, 2, sigma_a_from_melanin(4, 0.2f))};
}

/// Hair before a wall, over a floor, under every kind of light.
inline SceneParts parts_of_room(std::vector<PlacedHair> hair, int size) {
    PlacedMesh wall = square(4, {0.7f, 0.5f, 0.3f}), floor = square(4, Rgb(0.6f));
    wall.placement.m[11] = -2;
    floor.placement.m = {1, 0, 0, 0, 0, 0, 1, -1.4, 0, -1, 0, 0};  // facing +y
    EnvironmentLight sky;
    sky.radiance = {0.1f, 0.15f, 0.25f};
    const std::vector<Light> lights = {PointLight{{1, 3, 4}, Rgb(12)}, SpotLight{{-3, 2, 5}, {0, 0, 0}, 50, Rgb(20)},
                                       DistantLight{{0.2, -0.5, -1}, Rgb(0.5f)},
                                       QuadLight{{-1, 3, 1}, {{2, 0, 0}, {0, 0.5, 1}}, Rgb(2)}, sky};
    return {std::move(hair), {wall, floor}, lights, camera_on_z(8, 32, size)};
}
inline Scene in_room(std::vector<PlacedHair> hair, int size) { return assembled(parts_of_room(std::move(hair), size)); }

inline Scene two_tufts(int size) { return in_room(two_balls(), size); }

}  // namespace tress::test
