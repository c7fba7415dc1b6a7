// SPDX-License-Identifier: MIT
#include "core/environment.h"

#include <doctest/doctest.h>

#include "core/rng.h"
#include "core/sampler.h"
#include "core/sampling.h"

using namespace tress;

namespace {

Image noise_sky(int width, int height, uint64_t key) {
    Image image = make_image(width, height);
    for (size_t i = 0; i < image.pixel.size(); ++i) {
        const uint64_t pixel = hash(key, i);
        image.pixel[i] = Rgb(random(pixel, 0), random(pixel, 1), random(pixel, 2));
    }
    return image;
}

/// Integral over the sphere of f, by midpoints even in azimuth and cosine.
template <class F>
double integrate(int rows, const F& f) {
    double sum = 0;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < 2 * rows; ++x)
            sum += double(
                f(sample_uniform_sphere({(float(y) + 0.5f) / float(rows), (float(x) + 0.5f) / float(2 * rows)})));
    return 4 * double(kPi) * sum / (2.0 * rows * rows);
}

/// As in light.h: u to the right, v downwards, in [0, 1].
Vec3 direction_at(double u, double v) {
    const double phi = 2 * double(kPi) * (u - 0.5), theta = double(kPi) * v;
    return Vec3(DVec3(std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)));
}

}  // namespace

TEST_CASE("the middle of the map is -z, right of it +x, the top +y; rotation turns about +y") {
    Image image = noise_sky(8, 5, 1);
    image.at(4, 2) = image.at(3, 2) = Rgb(10, 0, 0);  // about the middle column
    image.at(6, 2) = image.at(5, 2) = Rgb(0, 10, 0);  // about three quarters
    for (int x = 0; x < 8; ++x) image.at(x, 0) = Rgb(0, 0, 7);
    const EnvironmentSampler still = make_environment_sampler(image, Rgb(1), 0);
    CHECK(radiance(still, {0, 0, -1}).x == doctest::Approx(10));
    CHECK(radiance(still, {1, 0, 0}).y == doctest::Approx(10));
    CHECK(radiance(still, {0, 1, 0}) == Rgb(0, 0, 7));
    const EnvironmentSampler turned = make_environment_sampler(image, Rgb(2), 90);
    CHECK(radiance(turned, {-1, 0, 0}).x == doctest::Approx(20));
    CHECK(radiance(turned, {0, 0, -1}).y == doctest::Approx(20));
    // Centres of texels give texels.
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 8; ++x)
            CHECK(glm::length(radiance(still, direction_at((x + 0.5) / 8, (y + 0.5) / 5)) - image.at(x, y)) < 1e-4);
}

TEST_CASE("the density integrates to 1 and is positive wherever there is radiance") {
    Image image = noise_sky(16, 8, 2);
    for (int y = 2; y < 8; ++y)
        for (int x = 0; x < 12; ++x) image.at(x, y) = Rgb(0);  // black but for a seam and the top
    image.at(9, 5) = Rgb(1e5f);
    const EnvironmentSampler e = make_environment_sampler(image, Rgb(1, 2, 0.5f), 33);
    // The density is constant in each of 16 x 8 texels: the grid misplaces up to a cell at each of the edges in azimuth
    // and in height; the brightest texels hold nearly all.
    CHECK(integrate(1024, [&](const Vec3& w) { return pdf_environment(e, w); }) == doctest::Approx(1).epsilon(0.01));
    for (uint32_t i = 0; i < 100000; ++i) {
        const Vec3 w = sample_uniform_sphere(sobol_sample2(5, i, 0));
        const bool lit = radiance(e, w) != Rgb(0), can_be_sampled = pdf_environment(e, w) > 0;
        CHECK_UNARY((!lit || can_be_sampled));
    }
}

TEST_CASE("sampled directions fall into texels as often as the density says, and samples equal look-ups") {
    const int width = 6, height = 4;
    const EnvironmentSampler e = make_environment_sampler(noise_sky(width, height, 3), Rgb(1), -70);
    const EnvironmentSampler unturned = make_environment_sampler(noise_sky(width, height, 3), Rgb(1), 0);
    const int count = 1 << 16;
    std::vector<int> histogram(size_t(width * height), 0);
    const double angle = -70 * double(kPi) / 180;
    for (int i = 0; i < count; ++i) {
        const EnvironmentSample s = sample_environment(e, sobol_sample2(1, uint32_t(i), 0));
        CHECK_UNARY(s.pdf == pdf_environment(e, s.direction));
        CHECK_UNARY(s.radiance == radiance(e, s.direction));
        const double x = std::cos(angle) * s.direction.x - std::sin(angle) * s.direction.z;
        const double z = std::sin(angle) * s.direction.x + std::cos(angle) * s.direction.z;
        const int column = int((0.5 + std::atan2(x, -z) / (2 * double(kPi))) * width);
        const int row = int(std::acos(double(s.direction.y)) / double(kPi) * height);
        ++histogram[size_t(std::min(row, height - 1) * width + std::min(column, width - 1))];
    }
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            CAPTURE(row);
            CAPTURE(column);
            const double solid_angle =
                2 * double(kPi) / width *
                (std::cos(double(kPi) * row / height) - std::cos(double(kPi) * (row + 1) / height));
            const double pdf =
                double(pdf_environment(unturned, direction_at((column + 0.5) / width, (row + 0.5) / height)));
            // Independent samples would have a deviation of sqrt(n p); stratified ones have less.
            const double expected = pdf * solid_angle * count;
            CHECK(std::abs(histogram[size_t(row * width + column)] - expected) < 3 * std::sqrt(expected));
        }
}

TEST_CASE("the estimate of an integral by samples equals the sum over the sphere, with a sun too") {
    for (float sun : {1.0f, 1e5f, 1e9f}) {
        CAPTURE(sun);
        Image image = noise_sky(32, 16, 4);
        image.at(20, 3) = Rgb(sun);
        const EnvironmentSampler e = make_environment_sampler(image, Rgb(1), 10);
        const auto integrand = [&](const Vec3& w) {
            return std::max(0.0f, dot(w, normalize(Vec3(1, 1, -1)))) * luminance(radiance(e, w));
        };
        const double exact = integrate(1024, integrand);
        double estimate = 0;
        const uint32_t count = 1 << 14;
        for (uint32_t i = 0; i < count; ++i) {
            const EnvironmentSample s = sample_environment(e, sobol_sample2(2, i, 0));
            estimate += double(integrand(s.direction) / s.pdf) / count;
        }
        // The integrand varies within a texel by about its own size: 1 / sqrt(n) = 0.8 % is an upper bound, and the
        // midpoint sum errs by some 1e-4.
        CHECK(estimate == doctest::Approx(exact).epsilon(0.01));
    }
}

TEST_CASE("a constant environment is uniform and needs no table") {
    const EnvironmentSampler e = make_environment_sampler(EnvironmentLight{});
    CHECK(e.cell_cdf.empty());
    CHECK(radiance(e, {0, 1, 0}) == Rgb(1));
    CHECK(pdf_environment(e, {1, 0, 0}) == pdf_uniform_sphere());
    CHECK(sample_environment(e, {0.3f, 0.6f}).pdf == pdf_uniform_sphere());
    CHECK(e.power == doctest::Approx(4 * double(kPi)));
}

TEST_CASE("black maps and black constants give nothing to sample") {
    for (const Image& image : {make_image(4, 2), Image{}}) {
        const EnvironmentSampler e = make_environment_sampler(image, Rgb(0), 0);
        CHECK(e.power == 0);
        CHECK(sample_environment(e, {0.5f, 0.5f}).pdf == 0);
        CHECK(pdf_environment(e, {0, 1, 0}) == 0);
        CHECK(radiance(e, {0, 1, 0}) == Rgb(0));
    }
}

TEST_CASE("texels that are no radiance are black and counted") {
    Image image = noise_sky(4, 4, 6);
    image.at(0, 0).x = std::nanf("");
    image.at(1, 0).y = std::numeric_limits<float>::infinity();
    image.at(2, 2).z = -1;
    image.at(3, 3) = Rgb(1e38f);
    const EnvironmentSampler e = make_environment_sampler(image, Rgb(10), 0);
    CHECK(e.bad_texels == 4);
    for (uint32_t i = 0; i < 1000; ++i) {
        const EnvironmentSample s = sample_environment(e, sobol_sample2(3, i, 0));
        CHECK_UNARY((is_finite(s.radiance) && std::isfinite(s.pdf) && s.pdf > 0));
    }
}

TEST_CASE("poles, seams and maps of one texel are finite") {
    for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 7), std::pair(7, 1), std::pair(2048, 1024)}) {
        CAPTURE(width);
        const EnvironmentSampler e = make_environment_sampler(noise_sky(width, height, 7), Rgb(1), 123);
        for (const Vec3& w : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0.0f, 0.0f, -1), Vec3(-0.0f, 0, 1),
                              Vec3(1e-30f, 1, -1e-30f), direction_at(0, 0.5), direction_at(1, 0.5)}) {
            CHECK(is_finite(radiance(e, w)));
            CHECK(pdf_environment(e, w) > 0);
            CHECK(std::isfinite(pdf_environment(e, w)));
        }
        for (float u : {0.0f, 0.5f, 0x1.fffffep-1f})
            for (float v : {0.0f, 0.5f, 0x1.fffffep-1f}) {
                const EnvironmentSample s = sample_environment(e, {u, v});
                CHECK(glm::length(s.direction) == doctest::Approx(1).epsilon(1e-6));
                CHECK(s.pdf > 0);
            }
    }
}
