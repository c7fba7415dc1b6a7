// SPDX-License-Identifier: MIT
#include "core/shared_exponent.h"

#include <doctest/doctest.h>

#include "core/rng.h"

using namespace tress;

TEST_CASE("each channel is within 1/512 of the largest, over the range of floats") {
    for (int power = -37; power < 38; ++power)
        for (uint64_t i = 0; i < 200; ++i) {
            const float scale = std::pow(10.0f, float(power));
            const Rgb color =
                scale * Rgb(tress::random(i, 0), tress::random(i, 1), i % 3 ? tress::random(i, 2) : 0.998f);
            const Rgb off = abs(unpack(pack(color)) - color);
            CAPTURE(power);
            CAPTURE(i);
            // Halves of the last place of 8 bits, and where the largest rounds up to the next power of two all of it.
            CHECK(max_component(off) <= max_component(color) * (1.0f / 256));
            if (max_component(color) < 0.99f * std::exp2(std::ceil(std::log2(max_component(color)))))
                CHECK(max_component(off) <= max_component(color) * (1.0001f / 256));
        }
}

TEST_CASE("black, powers of two and the largest numbers keep their values") {
    CHECK(unpack(pack(Rgb(0))) == Rgb(0));
    for (const float x : {1.0f, 0.5f, 2.0f, 1024.0f, 0x1p-100f, 0x1p100f})
        CHECK(unpack(pack(Rgb(x, 0, x / 2))) == Rgb(x, 0, x / 2));
    CHECK(is_finite(unpack(pack(Rgb(3e38f)))));
    CHECK(unpack(pack(Rgb(1e-44f))) == Rgb(0));
}
