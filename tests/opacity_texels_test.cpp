// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/opacity_texels.h"

#include <doctest/doctest.h>

#include "tests/texel_fragments.h"

using namespace tress;

namespace {

constexpr DepthRange kUnit{0, 1};

OpacityTexels planes(const FragmentTile& tile, int layers, const DepthRange& range = kUnit) {
    return make_opacity_texels(tile, {.layers = layers, .follow = false}, range);
}

OpacityTexels followers(const FragmentTile& tile, int layers, const DepthRange& range = kUnit) {
    return make_opacity_texels(tile, {.layers = layers, .follow = true}, range);
}

OpacityTexels make(bool follow, const FragmentTile& tile, int layers, const DepthRange& range = kUnit) {
    return follow ? followers(tile, layers, range) : planes(tile, layers, range);
}

/// Of levels: half of one in 65535 of the whole optical depth, as light at most.
double level_rounding(double whole) { return 0.5 * whole / 65535; }

constexpr int kSamples = 4096;  // of a function of depth, each in the middle of its part

/// Mean absolute error over all depths of [0, 1] and all texels.
double mean_error(const OpacityTexels& texels, const std::vector<TestTexel>& fragments) {
    double sum = 0;
    for (size_t texel = 0; texel < fragments.size(); ++texel)
        for (int k = 0; k < kSamples; ++k) {
            const float depth = (float(k) + 0.5f) / kSamples;
            const double exact = exact_transmittance(fragments[texel], double(depth));
            sum += std::abs(double(transmittance(texels, texel, depth).x) - exact);
        }
    return sum / double(fragments.size()) / kSamples;
}

/// Light that the texels stop, on average.
double mean_loss(const std::vector<TestTexel>& fragments) {
    double sum = 0;
    for (const TestTexel& texel : fragments) sum += 1 - exact_transmittance(texel, 2);
    return sum / double(fragments.size());
}

}  // namespace

TEST_CASE("behind all hair a texel lets through the product of 1 - opacity") {
    std::vector<TestTexel> fragments = stiff_texels();
    for (uint64_t k = 0; k < 50; ++k) fragments.push_back(random_texel(hash(3, k), int(2 * k), 0, 1, 0.2f));
    const FragmentTile tile = tile_of(fragments, 3);
    for (const bool follow : {false, true})
        for (const int layers : {1, 3, 32, 1000}) {
            const OpacityTexels texels = make(follow, tile, layers);
            for (size_t texel = 0; texel < fragments.size(); ++texel)
                for (const float depth : {2.0f, 1e30f, kInfinity})
                    for (int c = 0; c < 3; ++c) {
                        CAPTURE(follow);
                        CAPTURE(layers);
                        CAPTURE(texel);
                        CAPTURE(c);
                        const double exact = exact_transmittance(fragments[texel], 2, c);
                        const double found = double(transmittance(texels, texel, depth)[c]);
                        CHECK(std::abs(found - exact) <= transmittance_rounding(exact));
                    }
        }
}

TEST_CASE("an opacity too small to be seen in 1 - opacity keeps its depth") {
    const FragmentTile tile = tile_of({{{0.5f, Rgb(1e-8f)}}});
    for (const bool follow : {false, true})
        CHECK(make(follow, tile, 4).total[0][0] == doctest::Approx(1e-8).epsilon(4 * kRounding));
}

TEST_CASE("planes lose no light until one layer before the first hair") {
    for (const int layers : {1, 2, 8, 64}) {
        const std::vector<TestTexel> fragments = random_texels(4, 100, 20, 0.5f, 1, 0.2f);
        const OpacityTexels texels = planes(tile_of(fragments), layers);
        for (size_t texel = 0; texel < fragments.size(); ++texel) {
            float first = 1;
            for (const TestFragment& fragment : fragments[texel]) first = glm::min(first, fragment.depth);
            CHECK(transmittance(texels, texel, first - 1.0f / float(layers)).x == 1);
            CHECK(transmittance(texels, texel, 0).x == 1);
            CHECK(transmittance(texels, texel, -3).x == 1);
        }
    }
}

TEST_CASE("layers that follow the hair lose no light before it where planes do") {
    const std::vector<TestTexel> fragments = random_texels(5, 100, 20, 0.25f, 1, 0.2f);
    const FragmentTile tile = tile_of(fragments);
    const OpacityTexels follow = followers(tile, 8), even = planes(tile, 8);
    double loss = 0;
    for (size_t texel = 0; texel < fragments.size(); ++texel) {
        const float first = tile.depth[tile.first[texel]];
        for (const float depth : {-1.0f, 0.0f, 0.9f * first, first}) CHECK(transmittance(follow, texel, depth).x == 1);
        loss += 1 - double(transmittance(even, texel, first).x);
    }
    // Two or three fragments (20 in 6 layers) that stop a tenth each, of which half lies before the first on average:
    // a twentieth would do.
    CHECK(loss / double(fragments.size()) > 0.05);
}

TEST_CASE("light falls with depth and stays between 0 and 1 whatever the depth") {
    std::vector<TestTexel> fragments = stiff_texels();
    fragments.push_back({});
    const FragmentTile tile = tile_of(fragments, 3);
    for (const bool follow : {false, true})
        for (const int layers : {1, 7, 100})
            check_light_falls(make(follow, tile, layers), fragments.size(), -100, 1300);
}

TEST_CASE("at a plane the light is what hair before it lets through") {
    const std::vector<TestTexel> fragments = random_texels(6, 200, 100, 0, 1, 0.1f);
    const int layers = 16;
    const OpacityTexels even = planes(tile_of(fragments), layers);
    for (size_t texel = 0; texel < fragments.size(); ++texel) {
        const double rounding = level_rounding(double(even.total[0][texel]));
        for (int layer = 0; layer <= layers; ++layer) {
            const double depth = double(layer) / layers;
            const double exact = exact_transmittance(fragments[texel], depth);
            CAPTURE(texel);
            CAPTURE(layer);
            CHECK(std::abs(double(transmittance(even, texel, float(depth)).x) - exact) <=
                  rounding + transmittance_rounding(exact));
        }
    }
}

TEST_CASE("layers that follow the hair end at squares behind its first") {
    const int layers = 8;
    TestTexel texel = random_texel(7, 100, 0.25f, 1, 0.1f);
    texel.push_back({0.25f, Rgb(0.1f)});
    const OpacityTexels texels = followers(tile_of({texel}), layers);
    for (int layer = 0; layer <= layers; ++layer) {
        const double depth = 0.25 + double(layer * layer) / (layers * layers);
        const double exact = layer == 0 ? 1 : exact_transmittance(texel, depth);
        CAPTURE(layer);
        CHECK(std::abs(double(transmittance(texels, 0, float(depth)).x) - exact) <=
              level_rounding(double(texels.total[0][0])) + transmittance_rounding(exact));
    }
}

TEST_CASE("the mean error is at most the light lost in a layer's share of the depth, and falls as 1 / layers") {
    const int count = 16;
    const std::vector<TestTexel> fragments = random_texels(8, 200, count, 0, 1, 0.5f);
    const FragmentTile tile = tile_of(fragments);
    const double loss = mean_loss(fragments);
    for (const bool follow : {false, true}) {
        double before = 1;
        for (const int layers : {1, 4, 16, 64, 256, 1024}) {
            // Within a layer, table and truth lie between their common values at its ends, so the error there is at
            // most what the layer stops. The thickest layer is 1 / layers of the range; 2 / layers, less its end, where
            // they grow. Half a sample more for layers that do not end between samples.
            const OpacityTexels texels = make(follow, tile, layers);
            const double error = mean_error(texels, fragments);
            const double thickest = follow ? 2.0 / layers - 1.0 / layers / layers + 1.0 / kSamples : 1.0 / layers;
            CAPTURE(follow);
            CAPTURE(layers);
            CAPTURE(error);
            CHECK(error <= thickest * loss + level_rounding(count * std::log(2.0)));  // opacities are below a half
            // With many fragments to a layer their number in part of it wanders as its root, and so does the error:
            // half for four times the layers. With one at most, the error is there in 1 / layers of the range: a
            // quarter. A fifth is left for chance and for layers between the two.
            CHECK(error < before / (layers > 4 * count ? 3.2 : layers > 1 ? 1.6 : 1));
            if (layers > 4 * count && !follow) CHECK(error > before / 4.8);
            before = error;
        }
    }
}

TEST_CASE("layers that grow err less than even ones from the first hair on would, where hair thins out behind it") {
    const int layers = 32;
    std::vector<TestTexel> fragments;
    for (uint64_t key = 0; key < 100; ++key) {
        TestTexel texel;
        for (uint64_t k = 0; k < 80; ++k) {
            const float behind = -std::log1p(-random(hash(11, key), k)) / 12;  // as hair 3 cm deep in a ball of 36 cm
            texel.push_back({glm::min(0.25f * random(hash(12, key), 0) + behind, 1.0f), Rgb(0.03f)});
        }
        fragments.push_back(texel);
    }
    const FragmentTile tile = tile_of(fragments);
    const OpacityTexels texels = followers(tile, layers);
    double grown_error = 0, even_error = 0;
    for (size_t texel = 0; texel < fragments.size(); ++texel) {
        const double start = double(tile.depth[tile.first[texel]]);
        for (const TestFragment& fragment : fragments[texel]) {
            const double depth = double(fragment.depth), exact = exact_transmittance(fragments[texel], depth);
            const double layer = std::floor((depth - start) * layers), low = start + layer / layers;
            const double near = layer > 0 ? exact_transmittance(fragments[texel], low) : 1;
            const double far = exact_transmittance(fragments[texel], low + 1.0 / layers);
            const double even = near * std::pow(far / near, (depth - low) * layers);
            even_error += std::abs(even - exact);
            grown_error += std::abs(double(transmittance(texels, texel, fragment.depth).x) - exact);
        }
    }
    // The first 0.08 behind the first hair hold 1 - 1 / e of it: 2.7 even layers, or the first 9 of those that grow.
    // Errors go as the root of a layer's hair (its number in part of the layer wanders so), or faster.
    CAPTURE(even_error);
    CHECK(grown_error < 0.75 * even_error);
}

TEST_CASE("hair at the ends of the range, and outside by rounding, is counted") {
    const DepthRange range{0.1f, 0.7f};
    for (const float depth : {0.1f, std::nextafter(0.1f, 0.0f), 0.7f, std::nextafter(0.7f, 1.0f), 0.0f, 3.0f})
        for (const bool follow : {false, true})
            for (const int layers : {1, 3, 10, 1000}) {
                CAPTURE(depth);
                CAPTURE(layers);
                const OpacityTexels texels =
                    make(follow, tile_of({{{0.3f, Rgb(0.5f)}, {depth, Rgb(0.5f)}}}), layers, range);
                CHECK(double(transmittance(texels, 0, 4).x) == doctest::Approx(0.25).epsilon(12 * kRounding));
                CHECK(transmittance(texels, 0, -1).x == 1);
            }
}

TEST_CASE("hair that is all at one depth of the view is a step behind it") {
    const OpacityTexels texels = planes(tile_of({{{5, Rgb(0.5f)}, {5, Rgb(0.5f)}}}), 8, {5, 5});
    CHECK(transmittance(texels, 0, std::nextafter(5.0f, 0.0f)).x == 1);
    CHECK(transmittance(texels, 0, 5).x == 1);
    CHECK(double(transmittance(texels, 0, std::nextafter(5.0f, 6.0f)).x) ==
          doctest::Approx(0.25).epsilon(12 * kRounding));
}

TEST_CASE("texels without hair let all light through and cost an index") {
    const FragmentTile tile = tile_of({{}, {}, {{0.5f, Rgb(0.5f)}}, {}});
    for (const bool follow : {false, true}) {
        const OpacityTexels texels = make(follow, tile, 32);
        for (const size_t texel : {0u, 1u, 3u}) CHECK(transmittance(texels, texel, 2) == Rgb(1));
        CHECK(bytes(texels) == 4 * 4 + 4 + 32 * 2 + (follow ? 4u : 0u));
    }
    // A view where no hair is found has no range.
    const OpacityTexels none = planes(tile_of({{}, {}}), 32, {kInfinity, -kInfinity});
    CHECK(transmittance(none, 1, 0.5f) == Rgb(1));
}

TEST_CASE("appended tiles keep what each lets through") {
    const std::vector<FragmentTile> tiles = {tile_of({{}, {}}, 3), tile_of(random_texels(9, 5, 30, 0, 1, 0.2f), 3),
                                             tile_of({{}}, 3),
                                             tile_of({{{0.5f, Rgb(0.1f, 0.2f, 0.3f)}}, {}, {{0.7f, Rgb(0.5f)}}}, 3)};
    for (const bool follow : {false, true}) {
        OpacityTexels all;
        std::vector<OpacityTexels> parts;
        size_t sum = 0;
        for (const FragmentTile& tile : tiles) {
            parts.push_back(make(follow, tile, 8));
            append(all, parts.back());
            sum += bytes(parts.back());
        }
        CHECK(bytes(all) == sum);
        size_t texel = 0;
        for (const OpacityTexels& part : parts)
            for (size_t k = 0; k < part.rows.row.size(); ++k, ++texel)
                for (float depth = -0.1f; depth < 1.2f; depth += 0.05f)
                    CHECK(transmittance(all, texel, depth) == transmittance(part, k, depth));
    }
}

TEST_CASE("one channel and three agree where the three are equal") {
    std::vector<TestTexel> fragments = random_texels(10, 10, 50, 0, 1, 0.2f);
    for (TestTexel& texel : fragments)
        for (TestFragment& fragment : texel) fragment.opacity = Rgb(fragment.opacity.x);
    for (const bool follow : {false, true}) {
        const OpacityTexels one = make(follow, tile_of(fragments, 1), 16);
        const OpacityTexels three = make(follow, tile_of(fragments, 3), 16);
        for (size_t texel = 0; texel < fragments.size(); ++texel)
            for (float depth = 0; depth < 1.1f; depth += 0.01f)
                CHECK(transmittance(one, texel, depth) == transmittance(three, texel, depth));
    }
}
