// SPDX-License-Identifier: MIT
#include "core/light_sample.h"

#include <doctest/doctest.h>

using namespace tress;

TEST_CASE("a quad light's irradiance is its closed form") {
    // Point below the corner of a parallel rectangle a x b at distance c, facing it: E = L / 2 (A + B) with
    // A = a / sqrt(a^2 + c^2) atan(b / sqrt(a^2 + c^2)), B likewise with a and b exchanged (form factor of a
    // differential element to a parallel rectangle with a corner above it, times pi L).
    const double a = 2, b = 1, c = 1.5;
    const QuadLight light{{0, 0, c}, {{0, b, 0}, {a, 0, 0}}, Rgb(1)};  // shines along -z
    const int n = 200;
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const Vec2 u((float(i) + 0.5f) / float(n), (float(j) + 0.5f) / float(n));
            const LightSample s = sample(light, Vec3(0), u);
            sum += double(s.irradiance.x) * double(s.direction.z);
        }
    const auto half = [&](double p, double q) { return p / std::hypot(p, c) * std::atan(q / std::hypot(p, c)); };
    // Midpoint rule: error of order 1 / n^2.
    CHECK(sum / (n * n) == doctest::Approx(0.5 * (half(a, b) + half(b, a))).epsilon(1e-4));
}

TEST_CASE("a quad light shines on one side only") {
    const QuadLight light{{-1, -1, 0}, {{2, 0, 0}, {0, 2, 0}}, Rgb(1)};
    CHECK(sample(light, {0, 0, 1}, {0.3f, 0.6f}).irradiance.x > 0);
    CHECK(sample(light, {0, 0, -1}, {0.3f, 0.6f}).irradiance.x == 0);
}

TEST_CASE("a spot is full inside, none outside, and never rises towards its rim") {
    const SpotLight light{{0, 0, 0}, {0, 0, 1}, 60, Rgb(1)};
    float last = 1;
    for (int i = 0; i <= 400; ++i) {
        const float angle = 0.1f * float(i) * kPi / 180;
        const float e = sample(light, {std::sin(angle), 0, std::cos(angle)}, {}).irradiance.x;
        CHECK(e <= last + 1e-5f);
        if (angle < 0.89f * kPi / 6) CHECK(e == doctest::Approx(1).epsilon(1e-5));
        if (angle > 1.001f * kPi / 6) CHECK(e == 0);
        last = e;
    }
}

TEST_CASE("lights at the point itself, far away or very strong give finite light") {
    CHECK(sample(PointLight{{1, 2, 3}, Rgb(1)}, {1, 2, 3}, {}).irradiance == Rgb(0));
    CHECK(sample(PointLight{{1e-20, 0, 0}, Rgb(1)}, Vec3(0), {}).irradiance.x == kLargestIrradiance);
    const LightSample far = sample(PointLight{{1e200, 0, 0}, Rgb(1)}, Vec3(0), {});
    CHECK(far.irradiance.x == 0);
    CHECK(far.direction == Vec3(1, 0, 0));
}
