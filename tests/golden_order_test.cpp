// SPDX-License-Identifier: MIT
#include "core/golden_order.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

using namespace tress;

TEST_CASE("every number comes once") {
    for (uint32_t n = 0; n < 300; ++n) {
        CAPTURE(n);
        std::vector<uint32_t> order = golden_order(n);
        REQUIRE(order.size() == n);
        std::sort(order.begin(), order.end());
        for (uint32_t k = 0; k < n; ++k) CHECK(order[k] == k);
    }
}

TEST_CASE("every beginning leaves no wide gap") {
    for (const uint32_t n : {2u, 97u, 315u, 483u, 1000u, 1504u, 3600u, 4096u}) {
        CAPTURE(n);
        const std::vector<uint32_t> order = golden_order(n);
        std::vector<uint32_t> sorted;
        for (uint32_t k = 0; k < n; ++k) {
            sorted.insert(std::upper_bound(sorted.begin(), sorted.end(), order[k]), order[k]);
            uint32_t widest = n - sorted.back() + sorted.front();
            for (size_t i = 1; i < sorted.size(); ++i) widest = std::max(widest, sorted[i] - sorted[i - 1]);
            CAPTURE(k);
            CHECK(double(widest) <= 3 * double(n) / double(k + 1) + 3);
        }
    }
}
