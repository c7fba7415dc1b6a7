// SPDX-License-Identifier: MIT
#include "gather/projection/far_hair.h"

#include <array>

namespace tress {

std::span<const float, 1024> unpacked_depths() {
    static const std::array<float, 1024> depths = [] {
        std::array<float, 1024> d;
        d[0] = PackedDepth::kLargest;
        for (size_t i = 1; i < d.size(); ++i) d[i] = float(-4 * std::log(double(i) / 1023));
        return d;
    }();
    return depths;
}

}  // namespace tress
