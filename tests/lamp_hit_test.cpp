// SPDX-License-Identifier: MIT
// A quad lamp met by rays and the same lamp sampled agree on where it is and how likely.
#include <doctest/doctest.h>

#include "core/light_sample.h"
#include "core/rng.h"

using namespace tress;

namespace {

/// A skew parallelogram of about this size about `center`, shining towards -z.
QuadLight skew_quad(const DVec3& center, double size) {
    const DVec3 a = size * DVec3(0.2, 1, 0.1), b = size * DVec3(1.3, 0.4, -0.2);
    return {center - 0.5 * (a + b), {a, b}, Rgb(2, 3, 4)};
}

/// Towards the point of a lamp that is u, v along its edges.
Vec3 towards(const QuadLight& light, const Vec3& from, double u, double v) {
    return Vec3(normalize(light.corner + u * light.edge[0] + v * light.edge[1] - DVec3(from)));
}

}  // namespace

TEST_CASE("a ray towards a sampled point of a lamp meets it there, with the density of the sample") {
    for (const double size : {1e-4, 1.0, 1e5}) {
        const QuadLight light = skew_quad({0.3, -0.2, 2 + size}, size);
        for (uint64_t k = 0; k < 1000; ++k) {
            const Vec3 from(2 * random(1, k) - 1, 2 * random(2, k) - 1, 0);
            // Inside by more than the rounding of a direction (6e-8 of the distance) shifts the point.
            const double inset = 4e-7 * (2 + size) / size;
            const auto inside = [&](uint64_t key) { return float(inset + (1 - 2 * inset) * double(random(key, k))); };
            const Vec2 u(inside(3), inside(4));
            const LightSample s = sample(light, from, u);
            CAPTURE(size);
            CAPTURE(k);
            REQUIRE(s.pdf > 0);
            const LampHit met = hit(light, from, s.direction);
            // Directions are rounded to float: distance and the cosine at the lamp take 1e-7 over that cosine, > 0.05.
            CHECK(met.distance == doctest::Approx(double(s.distance)).epsilon(1e-5));
            CHECK(met.pdf == doctest::Approx(double(s.pdf)).epsilon(1e-5));
            CHECK(met.radiance == light.radiance);
            for (int c = 0; c < 3; ++c)
                CHECK(s.irradiance[c] == doctest::Approx(double(light.radiance[c] / s.pdf)).epsilon(1e-6));
        }
    }
}

TEST_CASE(
    "from near, a ray drawn towards a lamp meets it with the density of the sample, but for rounding at its rim") {
    const QuadLight light = skew_quad({0, 0, 0}, 1);
    const DVec3 normal = normalize(cross(light.edge[0], light.edge[1]));
    constexpr int kCount = 1000;
    for (const double height : {1e-5, 1e-2, 0.3, 1.0})
        for (const double beside : {0.0, 0.3, 0.55}) {
            const Vec3 from(height * normal + beside * light.edge[1]);
            int missed = 0;
            for (uint64_t k = 0; k < kCount; ++k) {
                const LightSample s = sample(light, from, {random(7, k), random(8, k)});
                CAPTURE(height);
                CAPTURE(beside);
                REQUIRE(s.pdf > 0);
                const LampHit met = hit(light, from, s.direction);
                if (met.pdf == 0) {
                    ++missed;
                    continue;
                }
                CHECK(met.pdf == s.pdf);
                // The direction is rounded to float, by 1e-7 over the cosine at the lamp.
                const double cosine = -dot(normal, DVec3(s.direction));
                CHECK(met.distance == doctest::Approx(double(s.distance)).epsilon(1e-7 + 1e-7 / cosine));
            }
            // 1e-7 of rounding over the least angle that the lamp spans: 1e-4 where it is seen along its plane.
            CHECK(missed <= 5);
        }
}

TEST_CASE("the density of a lamp integrates to one over the directions that meet it, near and far") {
    // The last is below the lamp by a fifth of its size, where it spans much of the hemisphere.
    DVec3 center(0);
    SUBCASE("far") { center = {0.3, -0.2, 2.5}; }
    SUBCASE("near") { center = {0.3, -0.2, 1.5}; }
    SUBCASE("below") { center = {0.1, -0.2, 0.2}; }
    SUBCASE("beside") { center = {0.9, 0.2, 0.4}; }
    const QuadLight light = skew_quad(center, 1);
    constexpr int kRows = 1000, kColumns = 1000;
    double sum = 0;
    for (int i = 0; i < kRows; ++i)
        for (int k = 0; k < kColumns; ++k) {
            const float z = (float(i) + 0.5f) / kRows, phi = 2 * kPi * (float(k) + 0.5f) / kColumns;
            const float radius = safe_sqrt(1 - z * z);
            sum += double(hit(light, Vec3(0), {radius * std::cos(phi), radius * std::sin(phi), z}).pdf);
        }
    // A step at the rim: of N cells about sqrt(N) of a few per cent of the hemisphere lie across it, each half wrong.
    CHECK(sum * 2 * double(kPi) / (kRows * kColumns) == doctest::Approx(1).epsilon(2e-3));
}

TEST_CASE("a lamp has one density of sampled directions per area, whichever point is drawn") {
    const QuadLight light = skew_quad({0, 0, 3}, 1);
    const double area = length(cross(light.edge[0], light.edge[1]));
    const DVec3 normal = cross(light.edge[0], light.edge[1]) / area;
    for (uint64_t k = 0; k < 100; ++k) {
        const LightSample s = sample(light, Vec3(0), {random(5, k), random(6, k)});
        const double cosine = -dot(normal, DVec3(s.direction));
        CHECK(double(s.pdf) * cosine / square(double(s.distance)) == doctest::Approx(1 / area).epsilon(1e-5));
    }
}

TEST_CASE("rays beside a lamp, behind it, in its plane or away from it meet nothing") {
    const QuadLight light = skew_quad({0, 0, 2}, 1);
    const auto nothing = [&](const Vec3& from, const Vec3& direction) {
        const LampHit met = hit(light, from, direction);
        return met.distance == kInfinity && met.pdf == 0 && met.radiance == Rgb(0);
    };
    const Vec3 from(0, 0, 0);
    CHECK_FALSE(nothing(from, towards(light, from, 0.5, 0.5)));
    for (const double outside : {-0.01, 1.01}) {
        CHECK(nothing(from, towards(light, from, outside, 0.5)));
        CHECK(nothing(from, towards(light, from, 0.5, outside)));
    }
    CHECK(nothing(from, -towards(light, from, 0.5, 0.5)));
    const Vec3 behind(0, 0, 4);
    CHECK(nothing(behind, towards(light, behind, 0.5, 0.5)));
    CHECK(sample(light, behind, {0.5f, 0.5f}).pdf == 0);

    const QuadLight flat{{-1, -1, 0}, {{0, 2, 0}, {2, 0, 0}}, Rgb(1)};
    CHECK(hit(flat, {-5, 0, 0}, {1, 0, 0}).distance == kInfinity);
    CHECK(hit(flat, {0, 0, 0}, {1, 0, 0}).distance == kInfinity);
    CHECK(hit(flat, {0, 0, 0}, {0, 0, 1}).distance == kInfinity);
    CHECK(hit(QuadLight{{0, 0, 1}, {{1, 0, 0}, {2, 0, 0}}, Rgb(1)}, Vec3(0), {0, 0, 1}).distance == kInfinity);
}

TEST_CASE("lamps of absurd size have finite densities") {
    for (const double size : {1e-30, 1e-18, 1e18}) {
        CAPTURE(size);
        const QuadLight light{{-0.5 * size, -0.5 * size, 1}, {{0, size, 0}, {size, 0, 0}}, Rgb(1)};
        const LampHit met = hit(light, Vec3(0), {0, 0, 1});
        const LightSample s = sample(light, Vec3(0), {0.5f, 0.5f});
        CHECK(std::isfinite(met.pdf));
        CHECK(std::isfinite(s.pdf));
        CHECK(met.pdf > 0);
        CHECK(met.pdf == doctest::Approx(double(s.pdf)).epsilon(1e-5));
        CHECK(met.distance == doctest::Approx(1));
        CHECK(std::isfinite(s.irradiance.x));
    }
}
