// SPDX-License-Identifier: MIT
// Solid angles of spherical triangles against closed forms, and directions drawn in them.
#include "core/spherical_triangle.h"

#include <doctest/doctest.h>

#include <array>

#include "core/rng.h"

using namespace tress;

namespace {

constexpr double kPi64 = 3.14159265358979323846;

SphericalTriangle triangle(const DVec3& a, const DVec3& b, const DVec3& c) {
    SphericalTriangle t{normalize(a), normalize(b), normalize(c), 0};
    // From differences, which are exact enough where the corners are close.
    t.volume = std::abs(dot(a, cross(b - a, c - a))) / (length(a) * length(b) * length(c));
    return t;
}

const SphericalTriangle kOctant = triangle({1, 0, 0}, {0, 1, 0}, {0, 0, 1});
const SphericalTriangle kHalfFace = triangle({-1, -1, 1}, {1, -1, 1}, {1, 1, 1});  // of a cube

std::array<SphericalTriangle, 6> triangles() {
    return {kOctant,
            kHalfFace,
            triangle({0.2, 1, 3}, {-1, 0.3, 2}, {0.7, -0.4, 1}),
            triangle({1, 0, 0.01}, {-0.5, 0.86, 0.01}, {-0.5, -0.86, 0.01}),  // nearly a hemisphere
            triangle({1, 0, 1}, {-1, 1e-3, 1}, {-1, -1e-3, 1}),               // a sliver
            triangle({1, 0, 1e-4}, {-1, 0, 1e-4}, {0.3, 1, 0.5})};            // two corners nearly opposite
}

DVec3 drawn(const SphericalTriangle& t, double omega, uint64_t k) {
    return direction_in(t, omega * double(random(1, k)), double(random(2, k)));
}

/// Integral of the direction over the triangle: half the sum over its sides of their angle times the unit normal,
/// inwards, of their plane (Lambert's formula for all planes at once).
DVec3 integral_of_direction(const SphericalTriangle& t) {
    const DVec3 corner[3] = {t.pivot, t.from, t.to};
    DVec3 sum(0);
    for (int i = 0; i < 3; ++i) {
        const DVec3 &a = corner[i], &b = corner[(i + 1) % 3], &c = corner[(i + 2) % 3], normal = cross(a, b);
        const double angle = std::atan2(length(normal), dot(a, b));
        sum += (dot(normal, c) > 0 ? 0.5 : -0.5) * angle * normalize(normal);
    }
    return sum;
}

}  // namespace

TEST_CASE("known triangles have their solid angles") {
    CHECK(solid_angle(kOctant) == doctest::Approx(kPi64 / 2).epsilon(1e-14));
    CHECK(solid_angle(kHalfFace) == doctest::Approx(kPi64 / 3).epsilon(1e-14));  // six faces make 4 pi
    CHECK(solid_angle(triangle({1, 0, 0}, {-0.5, 0.8, 0}, {-0.5, -0.8, 0})) == doctest::Approx(2 * kPi64));
    CHECK(solid_angle(triangle({1, 0, 0}, {0, 1, 0}, {1, 1, 0})) == 0);
    CHECK(solid_angle(triangle({1, 2, 3}, {1, 2, 3}, {1, 2, 3})) == 0);
}

TEST_CASE("a rectangle has the solid angle of its closed form, from far, near and almost touching") {
    // 4 asin(a b / sqrt((a^2 + d^2)(b^2 + d^2))) for half sides a, b at distance d above the middle.
    for (const double d : {1e3, 10.0, 1.0, 0.1, 1e-3, 1e-6}) {
        const double a = 1.5, b = 0.4;
        const DVec3 corner[4] = {{-a, -b, d}, {a, -b, d}, {a, b, d}, {-a, b, d}};
        const double sum = solid_angle(triangle(corner[0], corner[1], corner[2])) +
                           solid_angle(triangle(corner[0], corner[2], corner[3]));
        CAPTURE(d);
        // The cosine of asin loses digits close to 2 pi: as much as d^2 / (a b) is uncertain, by 1e-16 / d.
        CHECK(sum ==
              doctest::Approx(4 * std::asin(a * b / std::sqrt((a * a + d * d) * (b * b + d * d)))).epsilon(1e-8));
    }
}

TEST_CASE("a tiny triangle has the solid angle of a flat one, and directions are uniform over it") {
    for (const double size : {1e-3, 1e-6, 1e-9}) {
        CAPTURE(size);
        const DVec3 a(0, 0, 1), u = size * DVec3(1, 0, 0), v = size * DVec3(0.3, 1, 0);
        const SphericalTriangle t = triangle(a, a + u, a + v);
        const double omega = solid_angle(t);
        CHECK(std::abs(omega / (0.5 * size * size) - 1) < size * size + 1e-14);
        // Shares of u and v are uniform over the triangle below the diagonal: mean 1/3, variance 1/18.
        constexpr int n = 10000;
        double of_u = 0, of_v = 0;
        for (uint64_t k = 0; k < n; ++k) {
            const DVec3 d = drawn(t, omega, k);
            of_v += d.y / d.z / size, of_u += (d.x - 0.3 * d.y) / d.z / size;
        }
        const double tolerance = 4 * std::sqrt(1 / 18.0 / n) + size;
        CHECK(std::abs(of_u / n - 1 / 3.0) < tolerance);
        CHECK(std::abs(of_v / n - 1 / 3.0) < tolerance);
    }
}

TEST_CASE("directions drawn in a triangle are unit, inside, and have the mean of a uniform density") {
    constexpr int n = 20000;
    for (const SphericalTriangle& t : triangles()) {
        const double omega = solid_angle(t);
        CAPTURE(omega);
        DVec3 sum(0), squares(0);
        double outside = 0, off_unit = 0;
        const DVec3 corner[3] = {t.pivot, t.from, t.to};
        for (uint64_t k = 0; k < n; ++k) {
            const DVec3 d = drawn(t, omega, k);
            sum += d, squares += d * d;
            off_unit = std::max(off_unit, std::abs(length(d) - 1));
            for (int i = 0; i < 3; ++i) {
                const DVec3 normal = normalize(cross(corner[i], corner[(i + 1) % 3]));
                const double side = dot(normal, corner[(i + 2) % 3]) > 0 ? 1 : -1;
                outside = std::max(outside, -side * dot(d, normal));
            }
        }
        CHECK(off_unit < 1e-15);
        CHECK(outside < 1e-11);  // rounding, over the 1e-4 by which corners are not opposite
        const DVec3 mean = sum / double(n), expected = integral_of_direction(t) / omega;
        for (int c = 0; c < 3; ++c) {
            const double error = std::sqrt(std::max(squares[c] / n - mean[c] * mean[c], 0.0) / n);
            CHECK(std::abs(mean[c] - expected[c]) < 4 * error + 1e-12);
        }
    }
}

TEST_CASE("a part of a triangle gets its share of the directions") {
    constexpr int n = 20000;
    for (const SphericalTriangle& t : triangles()) {
        const double omega = solid_angle(t);
        const DVec3 middle = normalize(t.pivot + t.from);
        const DVec3 plane = cross(middle, t.to);  // halves the triangle along another arc than those that are swept
        const double share = solid_angle(triangle(t.from, t.to, middle)) / omega;
        int count = 0;
        for (uint64_t k = 0; k < n; ++k) count += dot(plane, drawn(t, omega, k)) * dot(plane, t.from) > 0;
        CAPTURE(omega);
        CAPTURE(share);
        CHECK(std::abs(double(count) / n - share) < 4 * std::sqrt(share * (1 - share) / n));
    }
}

TEST_CASE("the ends of the sweep are the triangle's sides") {
    for (const SphericalTriangle& t : triangles()) {
        const double omega = solid_angle(t);
        // Nearly opposite corners: rounding over the 1e-4 by which they are not.
        CHECK(length(direction_in(t, 0, 1) - t.from) < 1e-11);
        CHECK(length(direction_in(t, omega, 1) - t.to) < 1e-11);
        CHECK(length(direction_in(t, 0.3 * omega, 0) - t.pivot) < 1e-15);
    }
}

TEST_CASE("triangles of no area, or whose corners are opposite, give unit directions") {
    const DVec3 x(1, 0, 0), y(0, 1, 0);
    for (const SphericalTriangle& t :
         {SphericalTriangle{x, x, x, 0}, SphericalTriangle{x, -x, y, 0}, SphericalTriangle{x, x, -x, 1e-300},
          SphericalTriangle{x, y, -x, 1e-300}, SphericalTriangle{y, x, -x, 1e-20}})
        for (const double part : {0.0, 0.5, 1.0})
            for (const double along : {0.0, 0.5, 1.0})
                CHECK(length(direction_in(t, part * solid_angle(t), along)) == doctest::Approx(1).epsilon(1e-14));
}
