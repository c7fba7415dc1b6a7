// SPDX-License-Identifier: MIT
#include "core/light_sample.h"

#include <doctest/doctest.h>

#include "core/rng.h"

using namespace tress;

namespace {

double longer_diagonal(const QuadLight& light) {
    return std::max(length(light.edge[0] + light.edge[1]), length(light.edge[0] - light.edge[1]));
}

/// A skew parallelogram about the origin, shining towards -z.
QuadLight skew_quad(double size = 1) {
    const DVec3 a = size * DVec3(0.2, 1, 0), b = size * DVec3(1.3, 0.4, 0);
    return {-0.5 * (a + b), {a, b}, Rgb(1)};
}

/// On the side that shines, at this distance from the middle.
Vec3 point_at(double distance, const DVec3& direction) { return Vec3(distance * normalize(direction)); }

/// Integral of radiance times direction over a lamp's solid angle, of which a surface with normal N gets the part along
/// N: half the sum over its edges of their angle times the unit normal, inwards, of their plane (Lambert 1760).
DVec3 vector_irradiance(const QuadLight& light, const Vec3& point) {
    const DVec3 corner[4] = {light.corner, light.corner + light.edge[1], light.corner + light.edge[0] + light.edge[1],
                             light.corner + light.edge[0]};
    DVec3 sum(0);
    for (int i = 0; i < 4; ++i) {
        const DVec3 a = normalize(corner[i] - DVec3(point)), b = normalize(corner[(i + 1) % 4] - DVec3(point));
        sum += 0.5 * std::atan2(length(cross(a, b)), dot(a, b)) * normalize(cross(a, b));
    }
    return double(light.radiance.x) * sum;
}

struct Estimate {
    DVec3 mean{0}, error{0};  // standard
    float largest = 0, smallest_pdf = kInfinity, largest_pdf = 0;
};
Estimate estimate(const QuadLight& light, const Vec3& point, int n) {
    Estimate e;
    DVec3 squares(0);
    for (uint64_t k = 0; k < uint64_t(n); ++k) {
        const LightSample s = sample(light, point, {random(1, k), random(2, k)});
        const DVec3 brought = double(s.irradiance.x) * DVec3(s.direction);
        e.mean += brought / double(n), squares += brought * brought / double(n);
        e.largest = std::max(e.largest, s.irradiance.x);
        e.smallest_pdf = std::min(e.smallest_pdf, s.pdf), e.largest_pdf = std::max(e.largest_pdf, s.pdf);
    }
    e.error = sqrt(max(squares - e.mean * e.mean, DVec3(0)) / double(n));
    return e;
}

/// Directions are floats: their rounding is added to four standard errors.
void check_mean(const Estimate& e, const DVec3& expected) {
    for (int c = 0; c < 3; ++c) CHECK(std::abs(e.mean[c] - expected[c]) < 4 * e.error[c] + 1e-7 * length(expected));
}

}  // namespace

TEST_CASE("a quad light's irradiance is its closed form") {
    // From near. Point below the corner of a parallel rectangle a x b at distance c, facing it: E = L / 2 (A + B) with
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

TEST_CASE("a quad light shines on one side only, near and far") {
    const QuadLight light{{-1, -1, 0}, {{2, 0, 0}, {0, 2, 0}}, Rgb(1)};
    for (const float distance : {1e-6f, 1.0f, 10.0f}) {
        CHECK(sample(light, {0, 0, distance}, {0.3f, 0.6f}).irradiance.x > 0);
        CHECK(sample(light, {0, 0, -distance}, {0.3f, 0.6f}).irradiance.x == 0);
        CHECK(sample(light, {0, 0, -distance}, {0.3f, 0.6f}).pdf == 0);
    }
}

TEST_CASE("far from a quad light samples are uniform over its area, to the bit") {
    const QuadLight light = skew_quad();
    for (uint64_t k = 0; k < 1000; ++k) {
        const DVec3 direction(random(3, k) - 0.5f, random(4, k) - 0.5f, -0.01 - double(random(5, k)));
        const Vec3 point = point_at(longer_diagonal(light) * (1.001 + 5 * double(random(6, k))), direction);
        const Vec2 u(random(1, k), random(2, k));
        const DVec3 v = light.corner + double(u.x) * light.edge[0] + double(u.y) * light.edge[1] - DVec3(point);
        const LightSample s = sample(light, point, u);
        CHECK(s.place == u);
        CHECK(Vec3(s.direction) == Vec3(normalize(v)));
        const double projected = -dot(v, cross(light.edge[0], light.edge[1])) / length(v);
        CHECK(s.pdf == doctest::Approx(dot(v, v) / projected).epsilon(1e-6));
        CHECK(s.distance == doctest::Approx(length(v)).epsilon(1e-6));
        CHECK(s.irradiance.x <= 2);
    }
}

TEST_CASE("from near every sample of a quad light brings its radiance times its solid angle, and the mean is exact") {
    const QuadLight light = skew_quad();
    for (const double x : {0.0, 0.3, 0.66, 0.9})
        for (const double y : {0.0, 0.2, 0.7})
            for (const double height : {1e-7, 1e-3, 0.1, 0.7}) {
                CAPTURE(x);
                CAPTURE(y);
                CAPTURE(height);
                const Vec3 point(x, y, -height);
                const Estimate e = estimate(light, point, 4000);
                check_mean(e, vector_irradiance(light, point));
                CHECK(e.largest <= 6.2832f);
                CHECK(e.largest * e.largest_pdf == doctest::Approx(1).epsilon(1e-6));
                CHECK(e.smallest_pdf == e.largest_pdf);
            }
}

TEST_CASE("a sliver of a lamp, or one seen almost along its plane, lights as it should") {
    const auto check = [](const QuadLight& light, const Vec3& point) {
        const DVec3 expected = vector_irradiance(light, point);
        const Estimate e = estimate(light, point, 4000);
        REQUIRE(length(expected) > 0);
        for (int c = 0; c < 3; ++c) CHECK(std::abs(e.mean[c] - expected[c]) < 4 * e.error[c] + 1e-6 * length(expected));
    };
    const DVec3 along(1, 0, 0);
    for (const double width : {1e-2, 1e-4, 1e-6})
        for (const Vec3& point : {Vec3(0, 0, -0.3f), Vec3(0.6f, 0, -0.1f), Vec3(0.1f, 1e-3f, -1e-3f)}) {
            CAPTURE(width);
            check({-0.5 * (along + DVec3(0, width, 0)), {{0, width, 0}, along}, Rgb(1)}, point);
        }
    for (const float height : {1e-3f, 1e-5f, 1e-7f}) {
        CAPTURE(height);
        check(skew_quad(), Vec3(0.2f, -0.8f, -height));
        check(skew_quad(), Vec3(0.9f, 0.1f, -height));
    }
}

TEST_CASE("a quad light brings the same on both sides of the distance where it counts as near") {
    const QuadLight light = skew_quad();
    for (const DVec3& direction : {DVec3(0, 0, -1), DVec3(1, 0, -1), DVec3(-0.5, 1, -0.2), DVec3(1, 0.9, -0.01)}) {
        const Vec3 inside = point_at(longer_diagonal(light) * (1 - 1e-6), direction);
        const Vec3 outside = point_at(longer_diagonal(light) * (1 + 1e-6), direction);
        const Estimate near = estimate(light, inside, 20000), far = estimate(light, outside, 20000);
        CHECK(near.smallest_pdf == near.largest_pdf);
        CHECK(far.smallest_pdf < far.largest_pdf);
        check_mean(near, vector_irradiance(light, inside));
        check_mean(far, vector_irradiance(light, outside));
    }
}

TEST_CASE("near samples tell where on a quad light they end, and lie all over it") {
    const QuadLight light = skew_quad();
    const Vec3 point(0.3f, -0.2f, -0.4f);
    int quarter[4] = {};
    for (uint64_t k = 0; k < 1000; ++k) {
        const LightSample s = sample(light, point, {random(1, k), random(2, k)});
        const DVec3 there = light.corner + double(s.place.x) * light.edge[0] + double(s.place.y) * light.edge[1];
        CHECK(length(DVec3(point) + double(s.distance) * DVec3(s.direction) - there) < 1e-6);
        ++quarter[(s.place.x > 0.5f) + 2 * (s.place.y > 0.5f)];
    }
    for (const int count : quarter) CHECK(count > 100);
}

TEST_CASE("quad lights of any size are finite from points on them, at their corners and almost there") {
    for (const double size : {1e-160, 1e-80, 1e-30, 1e-6, 1.0, 1e6, 1e18, 1e37}) {
        CAPTURE(size);
        QuadLight light = skew_quad(size);
        for (const double beside : {0.0, 0.3, 0.5, 1.0})
            for (const double height : {0.0, 1e-30, 1e-12, 1e-6, 0.1}) {
                const DVec3 place = (beside - 0.5) * (light.edge[0] + light.edge[1]) - DVec3(0, 0, height * size);
                for (const DVec3& shift : {DVec3(0), -place})  // the point's own rounding hides heights, or not
                    for (const float x : {0.0f, 0.5f, 0x1.fffffep-1f})
                        for (const float y : {0.0f, 0.5f, 0x1.fffffep-1f}) {
                            QuadLight moved = light;
                            moved.corner += shift;
                            const Vec3 point(clamp(place + shift, DVec3(-3e38), DVec3(3e38)));
                            const LightSample s = sample(moved, point, {x, y});
                            CHECK(is_finite(s.direction));
                            CHECK(length(s.direction) == doctest::Approx(1).epsilon(1e-6));
                            CHECK(s.irradiance.x >= 0);
                            CHECK(s.irradiance.x <= 6.2832f);
                            CHECK(std::isfinite(s.pdf));
                            CHECK(s.distance >= 0);
                            CHECK(is_finite({s.place.x, s.place.y, 0}));
                            const LampHit met = hit(moved, point, s.direction);
                            CHECK(std::isfinite(met.pdf));
                        }
            }
    }
    const QuadLight line{{0, 0, 1}, {{1, 0, 0}, {2, 0, 0}}, Rgb(1)}, none{{0, 0, 1}, {{0, 0, 0}, {0, 0, 0}}, Rgb(1)};
    CHECK(sample(line, {0.5f, 0, 0.5f}, {0.5f, 0.5f}).irradiance == Rgb(0));
    CHECK(sample(line, {0.5f, 0, 1}, {0.5f, 0.5f}).irradiance == Rgb(0));
    CHECK(sample(none, {0, 0, 1}, {0.5f, 0.5f}).irradiance == Rgb(0));
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
