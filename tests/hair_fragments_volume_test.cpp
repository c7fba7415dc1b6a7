// SPDX-License-Identifier: MIT
// Many segments in one view: order, light that is left, threads; and hostile views.
#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include <algorithm>

#include "accel/build.h"
#include "tools/check/support/hair_views.h"

using namespace tress;
using namespace tress::fragments;

namespace {

/// Segments about [-1, 1]^3 with radii of their own.
Hair volume(size_t n, float radius, uint64_t seed) {
    Hair hair;
    hair.linked = true;
    Dice dice(seed);
    for (size_t i = 0; i < n; ++i) {
        const Vec3 start = dice.in_cube(), way = dice.direction();
        hair.add(start, start + (0.1f + 0.2f * dice.unit()) * way, radius, radius * (0.5f + dice.unit()));
    }
    return hair;
}

LightView volume_view(bool parallel, int size, uint64_t seed = 5) {
    Dice dice(seed);
    return random_view(dice, parallel, Vec3(0), 4, 1.6 / size, size);
}

bool same(const ViewFragments& a, const ViewFragments& b) {
    for (size_t i = 0; i < a.tiles.size(); ++i) {
        const FragmentTile &p = a.tiles[i], &q = b.tiles[i];
        if (p.first != q.first || p.depth != q.depth) return false;
        for (int c = 0; c < 3; ++c)
            if (p.opacity[c] != q.opacity[c]) return false;
    }
    return a.tiles.size() == b.tiles.size();
}

double left_over(const ViewFragments::Range& range, int channel) {
    double light = 1;
    for (uint32_t k = range.first; k < range.last; ++k) light *= 1 - double(range.tile.opacity[channel][k]);
    return light;
}

/// Mean over a texel of what rays through the tree leave of the light, 16 of them in strata.
std::vector<double> ray_means(const LightView& view, const KdTree& tree, const Attenuation& attenuation) {
    constexpr int kSide = 4;
    std::vector<double> means;
    for (int y = 0; y < view.height; ++y) {
        std::vector<float> ox, oy, oz, dx, dy, dz;
        for (int x = 0; x < view.width; ++x)
            for (int k = 0; k < kSide * kSide; ++k) {
                const uint64_t key = hash(hash(7, uint64_t(y * view.width + x)), uint64_t(k));
                const double u = double(random(key, 0)), v = double(random(key, 1));
                const glm::dvec2 place(x + (k % kSide + u) / kSide, y + (double(k / kSide) + v) / kSide);
                const Vec3 o(light_origin(view, place)), d(light_through(view, place));
                ox.push_back(o.x), oy.push_back(o.y), oz.push_back(o.z);
                dx.push_back(d.x), dy.push_back(d.y), dz.push_back(d.z);
            }
        const std::vector<float> near(ox.size(), 0.0f), far(ox.size(), kInfinity);
        std::vector<Rgb> light(ox.size());
        transmittance(tree, {ox, oy, oz, dx, dy, dz, near, far, {}, {}}, attenuation, 0, light, Isa::automatic);
        for (size_t x = 0; x < size_t(view.width); ++x) {
            double sum = 0;
            for (size_t k = 0; k < kSide * kSide; ++k) sum += double(light[x * kSide * kSide + k].x);
            means.push_back(sum / (kSide * kSide));
        }
    }
    return means;
}

/// Fragments of all segments, each projected alone: none is ever left out as being behind an opaque texel.
struct Layer {
    float depth, opacity;
};
std::vector<std::vector<Layer>> full_layers(const LightView& view, const Hair& hair, const Attenuation& attenuation) {
    std::vector<std::vector<Layer>> texels(size_t(view.width * view.height));
    for (const uint32_t point : hair.point) {
        SegmentView one = hair.view();
        one.point = std::span(&point, 1);
        const ViewFragments alone = project_all(view, one, attenuation);
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x) {
                const ViewFragments::Range r = alone.of(view, x, y);
                for (uint32_t k = r.first; k < r.last; ++k)
                    texels[size_t(y * view.width + x)].push_back({r.tile.depth[k], r.tile.opacity[0][k]});
            }
    }
    for (std::vector<Layer>& texel : texels)
        std::stable_sort(texel.begin(), texel.end(), [](const Layer& a, const Layer& b) { return a.depth < b.depth; });
    return texels;
}

}  // namespace

TEST_CASE("what fragments leave of the light is on average what rays through the hair tree leave") {
    // Segments are shorter than 10 texels: blocks of 16 x 16 are independent but for what crosses their edges.
    constexpr int kViewSize = 64, kBlock = 16;
    const Hair hair = volume(25000, 0.002f, 41);
    const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
    const Attenuation attenuation = inclined_attenuation(Rgb(0.5f));
    LightView among = volume_view(false, kViewSize);  // a lamp among the hair: 90 degrees, seen from the middle
    among.origin = DVec3(0), among.start = 0;
    among.low = glm::dvec2(-1), among.texel = glm::dvec2(2.0 / kViewSize);
    for (const LightView& view : {volume_view(true, kViewSize), volume_view(false, kViewSize), among}) {
        CAPTURE(view.parallel);
        CAPTURE(view.start);
        const ViewFragments all = project_all(view, hair.view(), attenuation);
        const std::vector<double> rays = ray_means(view, tree, attenuation);
        std::vector<double> block(square(kViewSize / kBlock), 0.0);
        double mean_light = 0;
        for (int y = 0; y < kViewSize; ++y)
            for (int x = 0; x < kViewSize; ++x) {
                const double light = left_over(all.of(view, x, y), 0);
                const double difference = light - rays[size_t(y * kViewSize + x)];
                block[size_t(y / kBlock * (kViewSize / kBlock) + x / kBlock)] += difference / square(kBlock);
                mean_light += light / square(kViewSize);
            }
        const double n = double(block.size());
        double mean = 0, squares = 0;
        for (const double b : block) mean += b / n;
        for (const double b : block) squares += square(b - mean);
        const double error = std::sqrt(squares / (n - 1) / n);
        CAPTURE(mean_light);
        CAPTURE(error);
        CHECK(mean_light > 0.1);
        CHECK(mean_light < 0.9);
        CHECK(error < 1e-3);
        CHECK(std::abs(mean) <= 4 * error);  // 15 degrees of freedom: once in 900 sets of random numbers
    }
}

TEST_CASE("fragments come in the order of depth, those at one depth in the order of segments") {
    // Each place has three segments, of fibers that stop ever more; so opacities tell their order.
    Hair hair;
    hair.linked = true;
    Dice dice(42);
    Attenuation attenuation;
    constexpr uint16_t kCopies = 3;
    for (uint16_t k = 0; k < kCopies; ++k)
        attenuation.table.push_back(constant_attenuation(Rgb(0.1f * float(k + 1))).table[0]);
    constexpr int kPlaces = 2000;
    std::vector<Vec3> start, end;
    for (int i = 0; i < kPlaces; ++i)
        start.push_back(dice.in_cube()), end.push_back(start.back() + 0.2f * dice.direction());
    for (uint16_t k = 0; k < kCopies; ++k)
        for (int i = 0; i < kPlaces; ++i) {
            const size_t place = size_t(k % 2 == 0 ? i : kPlaces - 1 - i);
            hair.add(start[place], end[place], 0.002f);
            attenuation.fiber_of_segment.push_back(k);
        }
    const LightView view = volume_view(false, 48);
    const ViewFragments all = project_all(view, hair.view(), attenuation);
    size_t ties = 0;
    for (const FragmentTile& tile : all.tiles) {
        REQUIRE(is_sound(tile, 1));
        for (size_t i = 0; i + 1 < tile.first.size(); ++i)
            for (uint32_t k = tile.first[i] + 1; k < tile.first[i + 1]; ++k) {
                if (tile.depth[k] != tile.depth[k - 1]) continue;
                ++ties;
                CHECK(tile.opacity[0][k] > tile.opacity[0][k - 1]);
            }
    }
    CHECK(ties > 10000);
}

TEST_CASE("fragments do not depend on the number of threads") {
    const Hair hair = volume(20000, 0.003f, 43);
    const Attenuation attenuation = inclined_attenuation(Rgb(0.2f, 0.5f, 1));
    const LightView view = volume_view(false, 150);
    const auto with = [&](size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return project_all(view, hair.view(), attenuation);
    };
    const ViewFragments one = with(1);
    CHECK(one.size() > 100000);
    CHECK(same(with(2), one));
    CHECK(same(with(7), one));
}

TEST_CASE("a part of a view sees what the whole view sees there") {
    const Hair hair = volume(3000, 0.002f, 44);
    const Attenuation attenuation = inclined_attenuation(Rgb(0.7f));
    const LightView whole = volume_view(false, 100);
    LightView part = whole;
    const glm::ivec2 shift(23, 41);
    part.low += glm::dvec2(shift) * whole.texel;
    part.width = 40, part.height = 30;
    const ViewFragments all = project_all(whole, hair.view(), attenuation);
    const ViewFragments some = project_all(part, hair.view(), attenuation);
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x) {
            double sums[2] = {0, 0};
            const ViewFragments::Range a = all.of(whole, x + shift.x, y + shift.y), b = some.of(part, x, y);
            for (uint32_t k = a.first; k < a.last; ++k) sums[0] += double(a.tile.opacity[0][k]);
            for (uint32_t k = b.first; k < b.last; ++k) sums[1] += double(b.tile.opacity[0][k]);
            CAPTURE(x);
            CAPTURE(y);
            // The same but for where pieces of a segment with one inclination each begin.
            CHECK(sums[0] == doctest::Approx(sums[1]).epsilon(5e-3));
        }
}

TEST_CASE("what is left out behind an opaque texel changes the light nowhere by more than that") {
    const Hair hair = volume(2500, 0.06f, 45);
    const Attenuation attenuation = constant_attenuation(Rgb(1.5f));
    for (const bool parallel : {true, false}) {
        const LightView view = volume_view(parallel, 20);
        const ViewFragments kept = project_all(view, hair.view(), attenuation);
        const std::vector<std::vector<Layer>> full = full_layers(view, hair, attenuation);
        size_t layers = 0;
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x) {
                const std::vector<Layer>& texel = full[size_t(y * view.width + x)];
                const ViewFragments::Range own = kept.of(view, x, y);
                layers += texel.size();
                double all_light = 1, light = 1;
                uint32_t k = own.first;
                for (const Layer& layer : texel) {
                    all_light *= 1 - double(layer.opacity);
                    for (; k < own.last && own.tile.depth[k] <= layer.depth; ++k)
                        light *= 1 - double(own.tile.opacity[0][k]);
                    // Layers at one depth may be in another order than here: pieces are those of one tile.
                    if (std::abs(light - all_light) > double(kOpaque) + 1e-6) {
                        CAPTURE(x);
                        CAPTURE(y);
                        CHECK(light == all_light);
                    }
                }
            }
        CHECK(kept.size() < layers * 3 / 4);  // some was left out
    }
}

TEST_CASE("one channel is filled where no fiber colours light, three where one does") {
    const Hair hair = volume(200, 0.01f, 46);
    const LightView view = volume_view(true, 40);
    const Attenuation grey = inclined_attenuation(Rgb(0.3f)), coloured = inclined_attenuation(Rgb(0.1f, 0.3f, 0.9f));
    CHECK_FALSE(colors_light(grey));
    CHECK(colors_light(coloured));
    Attenuation both{{grey.table[0], coloured.table[0]}, {}, std::vector<uint16_t>(200, 1), {}};
    CHECK(colors_light(both));
    const ViewFragments a = project_all(view, hair.view(), grey), b = project_all(view, hair.view(), both);
    for (const FragmentTile& tile : a.tiles) CHECK(is_sound(tile, 1));
    for (size_t i = 0; i < b.tiles.size(); ++i) {
        REQUIRE(is_sound(b.tiles[i], 3));
        CHECK(b.tiles[i].opacity[1] == a.tiles[i].opacity[0]);
        for (size_t k = 0; k < b.tiles[i].depth.size(); ++k) {
            CHECK(b.tiles[i].opacity[0][k] < b.tiles[i].opacity[1][k]);
            CHECK(b.tiles[i].opacity[2][k] > b.tiles[i].opacity[1][k]);
        }
    }
}

TEST_CASE("opacity is coverage times what the fiber stops at its inclination to the light") {
    Hair hair;
    hair.linked = true;
    hair.add({-0.5f, 0.1f, 0.2f}, {0.6f, -0.2f, 0.4f}, 0.001f);
    const Attenuation attenuation = inclined_attenuation(Rgb(0.8f));
    for (const bool parallel : {true, false}) {
        const LightView view = volume_view(parallel, 64);
        const ViewFragments covered = project_all(view, hair.view(), opaque());
        const ViewFragments stopped = project_all(view, hair.view(), attenuation);
        const DVec3 tangent = normalize(DVec3(hair.view().end(0)) - DVec3(hair.view().start(0)));
        size_t found = 0;
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x) {
                const ViewFragments::Range c = covered.of(view, x, y), s = stopped.of(view, x, y);
                REQUIRE(c.last - c.first == s.last - s.first);
                if (c.first == c.last) continue;
                ++found;
                const DVec3 light = normalize(light_through(view, {x + 0.5, y + 0.5}));
                const Rgb depth = attenuation.depth(0, float(std::abs(dot(tangent, light))));
                // Looked up once every 8 texels, 4.5 at most (and slanted) from here, of 0.5 degrees each: depth
                // changes by less than its own value a radian of that angle.
                const double a = 1 - std::exp(-double(depth.x)), slack = parallel ? 1e-4 : 4.5 * 1.5 * 0.4 / 64;
                CHECK(double(s.tile.opacity[0][s.first]) ==
                      doctest::Approx(double(c.tile.opacity[0][c.first]) * a).epsilon(slack));
            }
        CHECK(found > 20);
    }
}

namespace {

/// Projects, and returns the sum of coverage, after what must always hold.
double hostile(const LightView& view, const Hair& hair) {
    double sum = 0;
    const ViewFragments all = project_all(view, hair.view(), opaque());
    for (const FragmentTile& tile : all.tiles) {
        CHECK(is_sound(tile, 1));
        for (const float c : tile.opacity[0]) sum += double(c);
    }
    CHECK(std::isfinite(sum));
    return sum;
}

LightView plain_view(bool parallel, double texel, int size) {
    LightView view;
    view.frame = frame_about({0, 0, 1});
    view.parallel = parallel;
    view.texel = glm::dvec2(texel);
    view.low = -0.5 * double(size) * view.texel;
    view.width = view.height = size;
    return view;
}

Hair one_segment(const Vec3& start, const Vec3& end, float start_radius, float end_radius) {
    Hair hair;
    hair.linked = true;
    hair.add(start, end, start_radius, end_radius);
    return hair;
}

}  // namespace

TEST_CASE("a hair straight along the light is a dot as large as its section") {
    for (const float radius : {0.001f, 0.05f, 0.7f}) {
        CAPTURE(radius);
        const double disc = double(kPi) * square(double(radius));
        const Hair along = one_segment({0.3f, -0.2f, 3}, {0.3f, -0.2f, 5}, radius, radius);
        CHECK(hostile(plain_view(true, 0.05, 64), along) == doctest::Approx(disc / square(0.05)).epsilon(1e-4));
        // From a pinhole, through which the axis goes: the nearer end is what is seen.
        const Hair through = one_segment({0, 0, 4}, {0, 0, 8}, radius, radius);
        CHECK(hostile(plain_view(false, 0.02, 64), through) == doctest::Approx(disc / square(4 * 0.02)).epsilon(1e-3));
    }
}

TEST_CASE("hostile views and segments give finite fragments, quickly") {
    const float big = 1e30f, nan = std::numeric_limits<float>::quiet_NaN();
    for (const bool parallel : {true, false})
        for (const double texel : {1e-12, 1e-3, 1e12}) {
            CAPTURE(parallel);
            CAPTURE(texel);
            const LightView view = plain_view(parallel, texel, 70);
            for (const float radius : {1e-30f, 1e-3f, 1e5f, 1e30f}) {
                CAPTURE(radius);
                hostile(view, one_segment({0, 0, 1}, {1, 0, 1}, radius, radius));
                hostile(view, one_segment({0, 0, 1}, {1e-7f, 0, 1}, radius, 0));     // hardly a direction
                hostile(view, one_segment({0, 0, -1}, {0, 0, 1}, radius, radius));   // through a pinhole, along z
                hostile(view, one_segment({-1, 0, 0}, {1, 0, 0}, radius, radius));   // through a pinhole, across z
                hostile(view, one_segment({-1, 1, -1}, {1, 1, 1}, radius, radius));  // past it, from behind
                hostile(view, one_segment({0, 0, 0}, {1, 2, 3}, radius, radius));    // starts in it
                hostile(view, one_segment({-1e6f, 1e-3f, 2}, {1e6f, 1e-3f, 2}, radius, radius));
                hostile(view, one_segment({-big, -big, 1}, {big, big, 1}, radius, radius));
                hostile(view, one_segment({0, 0, -big}, {1, 1, big}, radius, radius));
                hostile(view, one_segment({0, 0, 1}, {0, 0, 1}, radius, radius));  // no length
                hostile(view, one_segment({0, 0, 1}, {0, 1, 1}, 0, radius));
                hostile(view, one_segment({0, 0, 1}, {0, 1, 1}, radius, 0));
            }
            CHECK(hostile(view, one_segment({nan, 0, 1}, {0, 1, 1}, 1, 1)) == 0);
            CHECK(hostile(view, one_segment({0, 0, 1}, {0, 1, kInfinity}, 1, 1)) == 0);
            CHECK(hostile(view, one_segment({0, 0, 1}, {0, 1, 1}, nan, 1)) == 0);
            CHECK(hostile(view, one_segment({0, 0, 1}, {0, 1, 1}, 0, 0)) == 0);
        }
}

TEST_CASE("hair far wider than the view covers all of it, once") {
    constexpr int kViewSize = 70;
    const double all = square(double(kViewSize));
    CHECK(hostile(plain_view(true, 1e-12, kViewSize), one_segment({-1, 0, 1}, {1, 0, 1}, 0.1f, 0.1f)) == all);
    CHECK(hostile(plain_view(true, 0.01, kViewSize), one_segment({-1, 0, 1}, {1, 0, 1}, 1e6f, 1e6f)) == all);
    CHECK(hostile(plain_view(false, 1e-9, kViewSize), one_segment({-1, 0.01f, 1}, {1, 0.02f, 1}, 0.1f, 0.2f)) == all);
}

TEST_CASE("segments outside the view, and a view of nothing, give nothing") {
    const LightView view = plain_view(false, 0.01, 70);
    CHECK(hostile(view, one_segment({5, 0, 1}, {5, 1e6f, 1}, 0.01f, 0.01f)) == 0);
    CHECK(hostile(view, one_segment({0, 0, -1}, {1, 1, -5}, 0.01f, 0.01f)) == 0);
    CHECK(hostile(view, Hair{}) == 0);
    LightView empty = view;
    empty.width = 0;
    CHECK(project_all(empty, one_segment({0, 0, 1}, {0, 1, 1}, 1, 1).view(), opaque()).tiles.empty());
}
