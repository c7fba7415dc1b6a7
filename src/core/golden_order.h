// SPDX-License-Identifier: MIT
// The numbers 0 … n - 1 in an order of which every beginning is spread evenly over them: that of the places of the
// first n multiples of the golden ratio, modulo 1 (a Kronecker sequence). No stride of a picture's rows beats with it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace tress {

inline std::vector<uint32_t> golden_order(uint32_t n) {
    constexpr uint64_t kInverseGoldenRatio = 0x9e3779b97f4a7c15ull;  // times 2^64
    std::vector<uint32_t> by_place(n), order(n);
    std::iota(by_place.begin(), by_place.end(), 0u);
    std::sort(by_place.begin(), by_place.end(),
              [](uint64_t a, uint64_t b) { return a * kInverseGoldenRatio < b * kInverseGoldenRatio; });
    for (uint32_t place = 0; place < n; ++place) order[by_place[place]] = place;
    return order;
}

}  // namespace tress
