// SPDX-License-Identifier: MIT
// Fragments of a few texels, and what they let through, in double: for tests of what shadow maps make of them.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "core/rng.h"
#include "gather/shadow_maps/hair_fragments.h"

namespace tress {

/// Of single precision, relative.
inline constexpr double kRounding = 0x1p-24;
inline constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

struct TestFragment {
    float depth;
    Rgb opacity;
};
using TestTexel = std::vector<TestFragment>;  // in any order

inline FragmentTile tile_of(const std::vector<TestTexel>& texels, int channels = 1) {
    FragmentTile tile;
    tile.first.push_back(0);
    for (TestTexel texel : texels) {
        std::stable_sort(texel.begin(), texel.end(), [](auto& a, auto& b) { return a.depth < b.depth; });
        for (const TestFragment& fragment : texel) {
            tile.depth.push_back(fragment.depth);
            for (int c = 0; c < channels; ++c) tile.opacity[c].push_back(fragment.opacity[c]);
        }
        tile.first.push_back(uint32_t(tile.depth.size()));
    }
    return tile;
}

/// Spread evenly over [near, far), with opacities up to `most`.
inline TestTexel random_texel(uint64_t key, int count, float near, float far, float most) {
    TestTexel texel;
    for (uint64_t k = 0; k < uint64_t(count); ++k) {
        const float place = random(key, 4 * k);
        const float red = random(key, 4 * k + 1);
        const float green = random(key, 4 * k + 2);
        const float blue = random(key, 4 * k + 3);
        texel.push_back({near + (far - near) * place, most * Rgb(red, green, blue)});
    }
    return texel;
}

inline std::vector<TestTexel> random_texels(uint64_t key, int texels, int count, float near, float far, float most) {
    std::vector<TestTexel> all;
    for (int k = 0; k < texels; ++k) all.push_back(random_texel(hash(key, uint64_t(k)), count, near, far, most));
    return all;
}

/// What the fragments before `depth` let through.
inline double exact_transmittance(const TestTexel& texel, double depth, int channel = 0) {
    double product = 1;
    for (const TestFragment& fragment : texel)
        if (double(fragment.depth) < depth) product *= 1 - double(fragment.opacity[channel]);
    return product;
}

/// Rounding of exp(-sum of depths) in single precision, of an exact value. Each depth and their total are rounded a few
/// times (log1p and exp to a unit in the last place, at most), so the sum errs by a share; beyond kOpaqueDepth it
/// stays.
inline double transmittance_rounding(double exact) {
    const double depth = exact > 0 ? std::min(-std::log(exact), 50.0) : 50.0;
    return exact * (8 * depth + 4) * kRounding + 2 * std::exp(-50.0);
}

/// Stiff cases that every kind of texel must keep, each with hair in [0, 1].
inline std::vector<TestTexel> stiff_texels() {
    std::vector<TestTexel> texels;
    texels.push_back({{0.5f, Rgb(0.3f)}});                                        // one fragment
    texels.push_back(TestTexel(50, {0.25f, Rgb(0.02f)}));                         // all at one depth
    texels.push_back({{0.125f, Rgb(0.1f)}, {0.5f, Rgb(1)}, {0.75f, Rgb(0.5f)}});  // opaque in the middle
    texels.push_back(TestTexel(3, {0.0f, Rgb(1)}));                               // opaque at once
    texels.push_back({{0.5f, Rgb(1e-8f)}});                                       // hardly there
    texels.push_back({{0.25f, Rgb(0)}, {0.5f, Rgb(0)}});                          // not there at all
    texels.push_back({{0, Rgb(0.25f)}, {1, Rgb(0.25f)}});                         // at the very ends
    texels.push_back(random_texel(1, 10000, 0, 1, 2e-8f));                        // many of next to nothing
    texels.push_back(random_texel(2, 10000, 0, 1, 1e-3f));                        // many
    texels.push_back({{0.5f, Rgb(0.5f, 0, 1)}, {std::nextafter(0.5f, 1.0f), 0.5f * Rgb(1, 0, 0)}});  // neighbours
    return texels;
}

/// Light falls with depth and stays within [0, 1], of three channels, over depths of [low, high] thousandths.
template <class Texels>
void check_light_falls(const Texels& texels, size_t count, int low, int high) {
    for (size_t texel = 0; texel < count; ++texel) {
        Rgb before = transmittance(texels, texel, -kInfinity);
        CHECK(before == Rgb(1));
        CHECK(transmittance(texels, texel, kNoNumber) == Rgb(1));
        for (int k = low; k <= high; ++k) {
            const Rgb here = transmittance(texels, texel, float(k) / 1000);
            for (int c = 0; c < 3; ++c) {
                CAPTURE(texel);
                CAPTURE(k);
                CHECK(here[c] >= 0);
                // Depths rise exactly; exp is rounded to a unit in the last place.
                CHECK(double(here[c]) <= double(before[c]) * (1 + 4 * kRounding));
            }
            before = here;
        }
    }
}

}  // namespace tress
