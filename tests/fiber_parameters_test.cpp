// SPDX-License-Identifier: MIT
// What a user may say of a fiber: ranges, melanin and colour.
#include <doctest/doctest.h>

#include "core/error.h"
#include "core/fiber.h"

using namespace tress;

TEST_CASE("a parameter out of range is refused by its name and range") {
    const auto refused = [](const char* name, auto change) {
        FiberParameters q;
        change(q);
        CAPTURE(name);
        CHECK_THROWS_WITH_AS(make_fiber(q), doctest::Contains(name), InputError);
        CHECK_THROWS_WITH_AS(make_fiber(q), doctest::Contains("expected a number from"), InputError);
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float bad : {-0.01f, 1.01f, nan}) {
        refused("beta_m", [&](FiberParameters& q) { q.beta_m = bad; });
        refused("beta_n", [&](FiberParameters& q) { q.beta_n = bad; });
    }
    for (const float bad : {0.99f, 0.0f, 11.0f, kInfinity, nan}) refused("eta", [&](auto& q) { q.eta = bad; });
    for (const float bad : {46.0f, -90.0f, nan}) refused("alpha", [&](auto& q) { q.alpha_degrees = bad; });
    for (const float bad : {-1e-6f, -kInfinity, nan}) refused("sigma_a", [&](auto& q) { q.sigma_a.y = bad; });
}

TEST_CASE("absorption follows melanin and colour") {
    CHECK(sigma_a_from_melanin(0, 0) == Rgb(0));
    CHECK(sigma_a_from_melanin(1, 0).z == doctest::Approx(1.37));
    CHECK(sigma_a_from_melanin(1, 2).x == doctest::Approx(0.419 + 2 * 0.187));
    CHECK_THROWS_AS(sigma_a_from_melanin(-1, 0), InputError);
    CHECK_THROWS_AS(sigma_a_from_melanin(0, kInfinity), InputError);

    const Rgb sigma_a = sigma_a_from_color(Rgb(1, 0.5f, 0), 0.3f);
    const double fit = 5.969 - 0.215 * 0.3 + 2.532 * 0.09 - 10.73 * 0.027 + 5.574 * 0.0081 + 0.245 * 0.00243;
    CHECK(sigma_a.x == 0);
    CHECK(sigma_a.y == doctest::Approx(square(std::log(0.5) / fit)));
    CHECK(std::isinf(sigma_a.z));
    CHECK_THROWS_AS(sigma_a_from_color(Rgb(0, 1.1f, 0), 0.3f), InputError);
    CHECK_THROWS_AS(sigma_a_from_color(Rgb(0, -0.1f, 0), 0.3f), InputError);
}
