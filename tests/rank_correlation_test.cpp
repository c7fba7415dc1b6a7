// SPDX-License-Identifier: MIT
#include "core/rank_correlation.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using tress::rank_correlation;

namespace {
double correlation(const std::vector<double>& a, const std::vector<double>& b) { return rank_correlation(a, b); }
}  // namespace

TEST_CASE("the same order is 1 and the reverse -1, however uneven the steps") {
    CHECK(correlation({1, 2, 3, 4}, {0.1, 7, 8, 1e9}) == doctest::Approx(1));
    CHECK(correlation({1, 2, 3, 4}, {5, 3, 2, -8}) == doctest::Approx(-1));
}

TEST_CASE("partial order is 1 - 6 sum d^2 / (n (n^2 - 1))") {
    // Ranks 1 2 3 4 5 against 2 1 4 3 5: d^2 sum to 4, 1 - 24 / 120.
    CHECK(correlation({10, 20, 30, 40, 50}, {2, 1, 4, 3, 5}) == doctest::Approx(0.8));
}

TEST_CASE("equal values share the mean of their ranks") {
    // Ranks 1, 2.5, 2.5, 4 against 1, 2, 3, 4: 4.5 / sqrt(4.5 * 5).
    CHECK(correlation({1, 2, 2, 3}, {1, 2, 3, 4}) == doctest::Approx(4.5 / std::sqrt(22.5)));
}

TEST_CASE("without an order there is no correlation") {
    CHECK(std::isnan(correlation({}, {})));
    CHECK(std::isnan(correlation({1}, {2})));
    CHECK(std::isnan(correlation({1, 2}, {3, 3})));
}
