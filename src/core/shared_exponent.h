// SPDX-License-Identifier: MIT
// A colour in four bytes, three mantissas and one exponent (Ward 1991, "Real pixels"): each channel within 1/512 of the
// largest.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/math.h"

namespace tress {

struct SharedExponent {
    uint8_t mantissa[3] = {}, exponent = 0;  // value = mantissa 2^(exponent - 136); exponent 0: black
};

/// `color` is finite and not negative.
inline SharedExponent pack(const Rgb& color) {
    int exponent = 0;
    const float largest = max_component(color);
    std::frexp(largest, &exponent);
    if (!(largest > 0) || exponent < -126) return {};
    if (largest >= std::ldexp(255.5f / 256, exponent)) ++exponent;  // the largest rounds up to 256
    const auto mantissa = [&](float x) { return uint8_t(std::lround(std::min(std::ldexp(x, 8 - exponent), 255.0f))); };
    return {{mantissa(color.r), mantissa(color.g), mantissa(color.b)}, uint8_t(exponent + 128)};
}

inline Rgb unpack(const SharedExponent& c) {
    if (c.exponent == 0) return Rgb(0);
    return Rgb(c.mantissa[0], c.mantissa[1], c.mantissa[2]) * std::ldexp(1.0f, int(c.exponent) - 136);
}

}  // namespace tress
