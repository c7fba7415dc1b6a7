// SPDX-License-Identifier: MIT
// What is asked of pictures: whether all of one is finite, dark, or that of another bit for bit.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "core/image.h"

namespace tress::test {

/// Values of all layers for which `counts`.
template <class Counts>
size_t count_values(const LayeredImage& picture, const Counts& counts) {
    size_t found = 0;
    for (const Layer& layer : picture.layers)
        for (const float v : layer.data) found += counts(v);
    return found;
}

inline size_t values(const LayeredImage& picture) {
    return count_values(picture, [](float) { return true; });
}
inline size_t values_not_finite(const LayeredImage& picture) {
    return count_values(picture, [](float v) { return !std::isfinite(v); });
}
inline bool all_finite(const LayeredImage& picture) { return values_not_finite(picture) == 0; }

/// Values that are not the same bits; where the layers are not the same ones, all.
inline size_t different_values(const LayeredImage& a, const LayeredImage& b) {
    if (a.layers.size() != b.layers.size()) return values(a) + values(b);
    size_t different = 0;
    for (size_t l = 0; l < a.layers.size(); ++l) {
        const Layer &x = a.layers[l], &y = b.layers[l];
        if (x.name != y.name || x.channels != y.channels || x.data.size() != y.data.size())
            return values(a) + values(b);
        for (size_t i = 0; i < x.data.size(); ++i)
            different += std::bit_cast<uint32_t>(x.data[i]) != std::bit_cast<uint32_t>(y.data[i]);
    }
    return different;
}

}  // namespace tress::test
