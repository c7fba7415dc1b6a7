// SPDX-License-Identifier: MIT
#include "core/error_fit.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/rng.h"

using namespace tress;

namespace {

/// floor + noise / t at 1, 2, 4 … seconds, each times 1 + spread x, x of variance 1 and mean 0.
std::vector<ErrorRun> runs_of(double floor, double noise, double spread, int runs, int points, uint64_t seed = 1) {
    std::vector<ErrorRun> all;
    for (int r = 0; r < runs; ++r) {
        ErrorRun run;
        for (int k = 0; k < points; ++k) {
            const double t = std::exp2(k),
                         x = std::sqrt(12.0) * (double(random(hash(seed, uint64_t(r)), uint64_t(k))) - 0.5);
            run.push_back({t, (floor + noise / t) * (1 + spread * x)});
        }
        all.push_back(run);
    }
    return all;
}

}  // namespace

TEST_CASE("exact data give back the bias and the noise they were made of") {
    const double floors[] = {0, 1e-6, 1e-3, 0.5}, noises[] = {1e-4, 0.01, 3};
    for (double floor : floors)
        for (double noise : noises) {
            CAPTURE(floor);
            CAPTURE(noise);
            const ErrorFit fit = fit_error(runs_of(floor, noise, 0, 2, 8));
            // Rounding of errors up to 3 to doubles, divided by the smallest difference of 1 / t, 1 / 128.
            CHECK(fit.floor == doctest::Approx(floor).epsilon(1e-9).scale(1e-9));
            CHECK(fit.noise == doctest::Approx(noise).epsilon(1e-9).scale(1e-9));
            CHECK(fit.residual < 1e-9);
            CHECK(fit.at(2) == doctest::Approx(floor + noise / 2).epsilon(1e-9).scale(1e-9));
        }
}

TEST_CASE("noisy data give both within four standard errors, and the stated errors are about right") {
    // Over many made-up studies the spread of the fits is what the standard errors say, within a factor of 1.5: the
    // jackknife over 8 runs knows its own to about a quarter.
    constexpr int kStudies = 200;
    const double floor = 0.002, noise = 0.05;
    double squares_floor = 0, squares_noise = 0, stated_floor = 0, stated_noise = 0;
    for (int i = 0; i < kStudies; ++i) {
        const ErrorFit fit = fit_error(runs_of(floor, noise, 0.1, 8, 7, uint64_t(i)));
        CHECK(std::abs(fit.floor - floor) < 0.15 * floor);
        CHECK(std::abs(fit.noise - noise) < 0.15 * noise);
        squares_floor += std::pow(fit.floor - floor, 2), squares_noise += std::pow(fit.noise - noise, 2);
        stated_floor += std::pow(fit.floor_error, 2), stated_noise += std::pow(fit.noise_error, 2);
    }
    CHECK(std::sqrt(stated_floor / squares_floor) == doctest::Approx(1).epsilon(0.5));
    CHECK(std::sqrt(stated_noise / squares_noise) == doctest::Approx(1).epsilon(0.5));
}

TEST_CASE("neither part is negative: errors that fall faster are noise, errors that grow are bias") {
    const ErrorRun falls{{1, 1}, {2, 0.3}, {4, 0.08}}, grows{{1, 0.1}, {2, 0.15}, {4, 0.2}};
    const ErrorFit noise = fit_error(std::vector<ErrorRun>{falls}), bias = fit_error(std::vector<ErrorRun>{grows});
    CHECK(noise.floor == 0);
    CHECK(noise.noise > 0);
    CHECK(bias.noise == 0);
    CHECK(bias.floor > 0.1);
    CHECK(bias.floor < 0.2);
}

TEST_CASE("an error below the floor is never reached, one above it when the fit says") {
    const ErrorFit fit{.floor = 0.01, .noise = 0.2};
    CHECK(std::isinf(fit.seconds_to(0.01)));
    CHECK(std::isinf(fit.seconds_to(0.001)));
    CHECK(fit.seconds_to(0.03) == doctest::Approx(10));
}

TEST_CASE("points without time, error or number are left out, and one time alone is all noise") {
    const double nan = std::nan("");
    CHECK(fit_error(std::vector<ErrorRun>{}).at(1) == 0);
    CHECK(fit_error(std::vector<ErrorRun>{{{0, 1}, {1, 0}, {nan, 1}, {1, nan}}}).at(1) == 0);
    const ErrorFit fit = fit_error(std::vector<ErrorRun>{{{2, 0.5}}, {{2, 0.7}}});
    CHECK(fit.floor == 0);
    CHECK(fit.at(2) == doctest::Approx(0.6).epsilon(0.05));
}
