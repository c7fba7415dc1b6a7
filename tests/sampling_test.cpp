// SPDX-License-Identifier: MIT
#include "core/sampling.h"

#include <doctest/doctest.h>

#include <functional>
#include <vector>

using namespace tress;

namespace {

constexpr int kSide = 512;  // samples: the centres of kSide x kSide squares

Vec2 centre(int i, int j) { return {(float(i) + 0.5f) / kSide, (float(j) + 0.5f) / kSide}; }

/// Mean over a grid of u of value(u).
double grid_mean(const std::function<double(const Vec2&)>& value) {
    double sum = 0;
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j) sum += value(centre(i, j));
    return sum / (double(kSide) * kSide);
}

/// If x = sample(u) has density p, the mean of f(x) / p(x) over u is the integral of f over what is sampled. Checked
/// for f = z^n of known integrals over directions above `cos_min`.
void check_directions(const std::function<Vec3(const Vec2&)>& sample, const std::function<double(const Vec3&)>& pdf,
                      double cos_min, int lowest_power = 0) {
    for (int power = lowest_power; power <= 3; ++power) {
        CAPTURE(power);
        const double exact = 2 * double(kPi) * (1 - std::pow(cos_min, power + 1)) / (power + 1);
        const double found = grid_mean([&](const Vec2& u) {
            const Vec3 w = sample(u);
            return std::pow(double(w.z), power) / pdf(w);
        });
        // The midpoint rule on 512 steps errs by 1e-5 of smooth f, by 512^-1 at the concentric map's creases.
        CHECK(found == doctest::Approx(exact).epsilon(2e-3).scale(0.01));
    }
    for (const Vec2& u : {Vec2(0, 0), Vec2(0, 0.5f), Vec2(0.5f, 0.5f), Vec2(0x1.fffffep-1f, 0), Vec2(0x1.fffffep-1f)})
        CHECK(glm::length(sample(u)) == doctest::Approx(1).epsilon(1e-6));
}

}  // namespace

TEST_CASE("directions have the densities they claim") {
    SUBCASE("sphere") {
        check_directions(
            sample_uniform_sphere, [](const Vec3&) { return pdf_uniform_sphere(); }, -1);
    }
    SUBCASE("hemisphere") {
        check_directions(
            sample_uniform_hemisphere, [](const Vec3&) { return pdf_uniform_hemisphere(); }, 0);
    }
    SUBCASE("cosine hemisphere") {  // from z^1 on: 1 / cos has a pole that the grid cannot sum
        check_directions(
            sample_cosine_hemisphere, [](const Vec3& w) { return pdf_cosine_hemisphere(w.z); }, 0, 1);
    }
    SUBCASE("cone") {
        for (float half_angle : {0.01f, 0.5f, 2.0f}) {
            const float height = one_minus_cos(half_angle);
            const auto sample = [&](const Vec2& u) { return sample_cone(u, height); };
            check_directions(
                sample, [&](const Vec3&) { return pdf_cone(height); }, std::cos(double(half_angle)));
        }
    }
}

TEST_CASE("a narrow cone keeps its width") {
    const float half_angle = 1e-5f;  // 1 - cos is 5e-11: nothing beside 1 in single precision
    const Vec3 edge = sample_cone({0x1.fffffep-1f, 0.25f}, one_minus_cos(half_angle));
    CHECK(edge.y == doctest::Approx(half_angle).epsilon(1e-5));
}

TEST_CASE("points are uniform on disc, triangle and parallelogram") {
    CHECK(grid_mean([](const Vec2& u) { return square(glm::length(sample_concentric_disc(u))); }) ==
          doctest::Approx(0.5).epsilon(1e-4));  // mean of r^2
    CHECK(grid_mean([](const Vec2& u) { return glm::length(sample_concentric_disc(u)) < 0.5f; }) ==
          doctest::Approx(0.25).epsilon(0.01));
    CHECK(sample_concentric_disc({0.5f, 0.5f}) == Vec2(0));
    CHECK(double(pdf_concentric_disc()) == doctest::Approx(1 / std::acos(-1.0)));

    for (int axis = 0; axis < 2; ++axis) {
        CHECK(grid_mean([&](const Vec2& u) { return sample_triangle(u)[axis]; }) ==
              doctest::Approx(1.0 / 3).epsilon(1e-4));
        CHECK(grid_mean([&](const Vec2& u) { return square(sample_triangle(u)[axis]); }) ==
              doctest::Approx(1.0 / 6).epsilon(1e-4));
    }
    CHECK(pdf_triangle({2, 0, 0}, {1, 3, 0}) == doctest::Approx(1.0 / 3));
    CHECK(pdf_parallelogram({2, 0, 0}, {1, 3, 0}) == doctest::Approx(1.0 / 6));
    CHECK(sample_parallelogram({0.5f, 0.25f}, {1, 1, 1}, {2, 0, 0}, {0, 4, 0}) == Vec3(2, 2, 1));
}

TEST_CASE("the Blackman-Harris filter has the window's density and moments") {
    const float radius = 1.5f;
    const int count = 1 << 16;
    // Moments of the window: of x^2 cos(k pi x) over [-1, 1] the integral is 4 (-1)^k / (k pi)^2; of x^2, 2 / 3.
    const double a[] = {0.35875, 0.48829, 0.14128, 0.01168}, pi = std::acos(-1.0);
    double variance = a[0] * 2 / 3;
    for (int k = 1; k < 4; ++k) variance += a[k] * 4 * (k % 2 ? -1 : 1) / square(k * pi);
    variance *= square(double(radius)) / (2 * a[0]);

    double mean = 0, second = 0, total = 0;
    std::vector<int> histogram(32, 0);
    float last = -radius;
    for (int i = 0; i < count; ++i) {
        const float x = sample_blackman_harris((float(i) + 0.5f) / count, radius);
        CHECK_UNARY(x >= last);
        last = x;
        mean += double(x) / count;
        second += square(double(x)) / count;
        ++histogram[std::min(size_t((x / radius + 1) * 16), size_t(31))];
        const double even = (2 * (i + 0.5) / count - 1) * double(radius);
        total += double(pdf_blackman_harris(float(even), radius)) * 2 * double(radius) / count;
    }
    CHECK(std::abs(mean) < 1e-6);
    CHECK(second == doctest::Approx(variance).epsilon(1e-4));
    CHECK(total == doctest::Approx(1).epsilon(1e-5));
    for (size_t bin = 0; bin < 32; ++bin) {  // Simpson's rule for the share of each bin; counts may be off by 2
        CAPTURE(bin);
        const auto p = [&](double b) {
            return double(pdf_blackman_harris(float((b / 16 - 1) * double(radius)), radius));
        };
        const double share = (p(double(bin)) + 4 * p(double(bin) + 0.5) + p(double(bin) + 1)) / 6 * double(radius) / 16;
        CHECK(std::abs(histogram[bin] - share * count) < 3 + 1e-3 * share * count);
    }
    CHECK(sample_blackman_harris(0, radius) == -radius);
    CHECK(sample_blackman_harris(0x1.fffffep-1f, radius) <= radius);
    CHECK(sample_blackman_harris(0.5f, radius) == doctest::Approx(0));
    CHECK(pdf_blackman_harris(1.6f, radius) == 0);
}
