// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/deep_texels.h"

#include <doctest/doctest.h>

#include <limits>

#include "core/error.h"
#include "tools/check/support/step_functions.h"

using namespace tress;

namespace {

constexpr double kHalfUnit = 1.0 / 131070;  // of 16 bits: greatest error of rounding a value

/// What float arithmetic of a look-up may add: a few roundings of values up to 1.
constexpr double kLookUp = 4 * 0x1p-24;

/// A tile of texels that hold 0 to 200 fragments; every fifth texel none.
FragmentTile random_tile(uint64_t key, int channels, int texels = kViewTile * kViewTile) {
    FragmentTile tile;
    tile.first.push_back(0);
    for (int t = 0; t < texels; ++t) {
        const uint64_t own = hash(key, uint64_t(t));
        const size_t count = t % 5 == 4 ? 0 : size_t(200 * random(own, 0));
        const float strength = random(own, 1);
        float depth = 30;
        for (uint64_t i = 0; i < count; ++i) {
            depth = next_depth(t % 7 == 3 ? 3 : 0, depth, random(hash(own, 2), i));
            tile.depth.push_back(depth);
            for (int c = 0; c < channels; ++c)
                tile.opacity[c].push_back(strength * random(hash(own, 3 + uint64_t(c)), i));
        }
        tile.first.push_back(uint32_t(tile.depth.size()));
    }
    return tile;
}

/// By definition: the product over hair before `depth`.
Rgb product_before(const FragmentTile& tile, size_t texel, double depth) {
    glm::dvec3 left(1);
    for (uint32_t i = tile.first[texel]; i < tile.first[texel + 1] && tile.depth[i] < depth; ++i)
        for (int c = 0; c < 3; ++c) left[c] *= 1 - double(tile.opacity[tile.opacity[1].empty() ? 0 : c][i]);
    return Rgb(left);
}

float furthest(const Rgb& a, const Rgb& b) { return max_component(abs(a - b)); }

/// One texel, one channel.
DeepTexels texel_of(std::vector<float> depth, std::vector<uint16_t> value) {
    DeepTexels texels;
    texels.first = {0, uint32_t(depth.size())};
    texels.depth = std::move(depth), texels.value[0] = std::move(value);
    return texels;
}

}  // namespace

TEST_CASE("a look-up is the product over hair before the depth, to within the error") {
    for (const int channels : {1, 3}) {
        CAPTURE(channels);
        const FragmentTile tile = random_tile(1, channels);
        for (const float error : {0.0f, 0.002f, 0.01f, 0.1f}) {
            CAPTURE(error);
            const DeepTexels texels = make_deep_texels(tile, error);
            double worst = 0;
            bool bounded = true;
            for (size_t t = 0; t + 1 < tile.first.size(); ++t) {
                for (uint32_t q = 0; q < 40; ++q) {
                    const uint32_t count = tile.first[t + 1] - tile.first[t];
                    float depth = 25 + 220 * random(hash(2, t), q);
                    // At a hair, just behind one, or anywhere.
                    if (q % 4 != 0 && count > 0) {
                        const float at = tile.depth[tile.first[t] + uint32_t(hash(3, q)) % count];
                        depth = q % 4 == 1 ? at : (q % 4 == 2 ? std::nextafter(at, 1e9f) : depth);
                    }
                    const Rgb found = transmittance(texels, t, depth), expected = product_before(tile, t, depth);
                    const double wrong = furthest(found, expected);
                    // Rounded to 16 bits; and where no channel has more left than that, what is behind is left out.
                    const double rounding = max_component(expected) > kHalfUnit ? kHalfUnit : 2 * kHalfUnit;
                    bounded &= wrong <= double(error) + rounding + kLookUp;
                    worst = std::max(worst, wrong);
                }
            }
            CHECK(bounded);
            CHECK(worst > 0.9 * double(error));
        }
    }
}

TEST_CASE("light falls along a texel, from exactly 1 at its first hair") {
    for (const int channels : {1, 3}) {
        const FragmentTile tile = random_tile(4, channels);
        const DeepTexels texels = make_deep_texels(tile, 0.01f);
        REQUIRE(texels.first.size() == tile.first.size());
        for (size_t t = 0; t + 1 < tile.first.size(); ++t) {
            const bool empty = tile.first[t] == tile.first[t + 1];
            REQUIRE((texels.first[t] == texels.first[t + 1]) == empty);
            const float start = empty ? 30 : tile.depth[tile.first[t]];
            if (!empty) CHECK(texels.depth[texels.first[t]] == start);
            CHECK(transmittance(texels, t, start) == Rgb(1));
            Rgb before(1);
            bool falls = true;
            for (float depth = 29; depth < 260; depth += 0.37f) {
                const Rgb now = transmittance(texels, t, depth);
                // Within a line two places may round the other way by an ulp of the value.
                falls &= glm::all(glm::lessThanEqual(now, before + 0x1p-23f)) && min_component(now) >= 0;
                before = now;
            }
            CHECK(falls);
        }
    }
}

TEST_CASE("a look-up is linear between nodes, constant behind them, and before a step at its depth") {
    const DeepTexels texels = texel_of({10, 12, 12, 20}, {65535, 52428, 26214, 13107});
    const float tolerance = 4 * 0x1p-24f;
    const auto light = [&](float depth) { return transmittance(texels, 0, depth).x; };
    CHECK(light(-kInfinity) == 1);
    CHECK(light(10) == 1);
    CHECK(std::abs(light(11) - 0.9f) <= tolerance);
    CHECK(std::abs(light(12) - 0.8f) <= tolerance);
    CHECK(std::abs(light(std::nextafter(12.0f, 13.0f)) - 0.4f) <= 1e-6f);  // the line falls by 2.4e-8 in an ulp of 12
    CHECK(std::abs(light(16) - 0.3f) <= tolerance);
    CHECK(std::abs(light(20) - 0.2f) <= tolerance);
    CHECK(light(21) == light(20));
    CHECK(light(kInfinity) == light(20));
    CHECK(light(std::numeric_limits<float>::quiet_NaN()) == 1);  // what is no number is before everything
}

TEST_CASE("the node behind which a depth falls is found for any number of nodes") {
    for (uint32_t count = 0; count < 70; ++count) {
        DeepTexels texels = texel_of({}, {});
        for (uint32_t i = 0; i < count; ++i) {
            texels.depth.push_back(float(i));
            texels.value[0].push_back(uint16_t(65535 - 655 * i));
        }
        texels.first[1] = count;
        bool right = true;
        for (uint32_t half = 0; half < 2 * count; ++half) {
            const float expected = 1 - 655.0f / 65535 * 0.5f * float(std::min(half, 2 * count - 2));
            right &= std::abs(transmittance(texels, 0, 0.5f * float(half)).x - expected) <= 4 * 0x1p-24f;
        }
        CAPTURE(count);
        CHECK(right);
        CHECK(transmittance(texels, 0, -1) == Rgb(1));
    }
}

TEST_CASE("behind hair that leaves nothing there are no nodes, and no light") {
    FragmentTile tile;
    tile.first = {0, 4};
    tile.depth = {1, 2, 3, 4};
    tile.opacity[0] = {0.5f, 1, 0.5f, 0.5f};
    const DeepTexels texels = make_deep_texels(tile, 0);
    CHECK(texels.depth == std::vector<float>{1, 1, 2, 2});
    CHECK(transmittance(texels, 0, 2).x > 0);
    CHECK(transmittance(texels, 0, 10) == Rgb(0));
}

TEST_CASE("tiles appended are their texels one after another") {
    for (const int channels : {1, 3}) {
        CAPTURE(channels);
        // The first tile has no hair, and so no channel.
        FragmentTile empty;
        empty.first.assign(11, 0);
        const FragmentTile tiles[] = {empty, random_tile(5, channels, 10), random_tile(6, channels, 10)};
        DeepTexels all;
        for (const FragmentTile& tile : tiles) append(all, make_deep_texels(tile, 0.01f));
        REQUIRE(all.first.size() == 31);
        CHECK(all.first.back() == all.depth.size());
        CHECK(bytes(all) == 31 * 4 + all.depth.size() * (4 + 2 * size_t(channels)));
        for (size_t t = 0; t < 30; ++t) {
            const DeepTexels own = make_deep_texels(tiles[t / 10], 0.01f);
            for (float depth = 29; depth < 150; depth += 1.3f)
                REQUIRE(transmittance(all, t, depth) == transmittance(own, t % 10, depth));
        }
    }
}

TEST_CASE("more nodes than 32 bits can index are reported") {
    const uint64_t most = std::numeric_limits<uint32_t>::max();
    CHECK_NOTHROW(check_node_count(most));
    CHECK_THROWS_AS(check_node_count(most + 1), InputError);
    CHECK_THROWS_AS(check_node_count(uint64_t(1) << 40), InputError);
}
