// SPDX-License-Identifier: MIT
// The rules of hair queries, one by one: instruction sets, batches, skipped segments, joints, ends, distance, layers.
#include <doctest/doctest.h>

#include "accel/build.h"
#include "core/error.h"
#include "core/frame.h"
#include "tools/check/support/segment_oracle.h"
#include "tools/check/support/tree_scenes.h"

using namespace tress;
using namespace tress::scenes;

namespace {

bool same(const Crossings& a, const Crossings& b) {
    return a.first == b.first && a.t == b.t && a.u == b.u && a.h == b.h && a.id == b.id;
}

Attenuation some_attenuation() {
    Attenuation a;
    a.table.resize(1);
    for (int row = 0; row < AttenuationTable::kRows; ++row)
        a.table[0].depth.push_back(Rgb(0.1f, 0.3f, 0.5f) * (1 + float(row) / AttenuationTable::kRows));
    return a;
}

std::vector<Rgb> coloured(const KdTree& tree, const RayBatch& rays, float cutoff, Isa isa = Isa::automatic) {
    std::vector<Rgb> out(rays.size());
    transmittance(tree, rays, some_attenuation(), cutoff, out, isa);
    return out;
}

KdTree one_hair(const Vec3& start, const Vec3& end, float start_radius, float end_radius) {
    Hair hair;
    hair.add(start, end, start_radius, end_radius);
    return build_segment_tree(hair.view(), AccelOptions{});
}

Rays single(const Vec3& o, const Vec3& d, float near = 0, float far = kInfinity) {
    Rays rays;
    rays.add(o, d, near, far);
    return rays;
}

}  // namespace

TEST_CASE("every instruction set gives the same bits") {
    for (const bool tapered : {false, true}) {
        for (const bool linked : {false, true}) {
            CAPTURE(tapered);
            CAPTURE(linked);
            Hair hair = linked ? strands(300, 10, 5) : random_hair(3000, 5, tapered);
            if (linked && tapered)
                for (size_t i = 0; i < hair.points.radius.size(); ++i) hair.points.radius[i] *= 0.5f + float(i % 3);
            const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
            const Rays rays = mixed_rays(5000, Vec3(0), 6);
            const RayBatch batch = rays.batch();
            const Nearest near = nearest(tree, batch, Isa::scalar);
            const Constant through = constant(tree, batch, 0.7f, 1e-3f, Isa::scalar);
            const std::vector<Rgb> colours = coloured(tree, batch, 1e-3f, Isa::scalar);
            const Crossings listed = crossings(tree, batch, Isa::scalar);
            for (const Isa isa : supported_isas()) {
                CAPTURE(int(isa));
                CHECK(nearest(tree, batch, isa) == near);
                CHECK(constant(tree, batch, 0.7f, 1e-3f, isa) == through);
                CHECK(coloured(tree, batch, 1e-3f, isa) == colours);
                CHECK(same(crossings(tree, batch, isa), listed));
            }
        }
    }
}

TEST_CASE("an instruction set that cannot run here is refused with those that can") {
    const std::vector<Isa> isas = supported_isas();
    CHECK(isas.back() == Isa::scalar);
    const KdTree tree = one_hair(Vec3(0), Vec3(1, 0, 0), 0.1f, 0.1f);
    const Rays rays = single(Vec3(0, 0, 1), Vec3(0, 0, -1));
    for (const Isa isa : {Isa::automatic, Isa::scalar, Isa::sse4, Isa::avx2, Isa::avx512}) {
        const bool known = isa == Isa::automatic || std::find(isas.begin(), isas.end(), isa) != isas.end();
        CAPTURE(int(isa));
        if (known)
            CHECK_NOTHROW(nearest(tree, rays.batch(), isa));
        else
            CHECK_THROWS_AS(nearest(tree, rays.batch(), isa), InputError);
    }
}

TEST_CASE("a batch gives what its rays give one by one") {
    const Hair hair = random_hair(3000, 7);
    const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
    const Rays rays = mixed_rays(1000, Vec3(0), 8);
    const Nearest near = nearest(tree, rays.batch());
    const Constant through = constant(tree, rays.batch(), 0.7f, 1e-3f);
    const std::vector<Rgb> colours = coloured(tree, rays.batch(), 1e-3f);
    for (size_t i = 0; i < rays.size(); ++i) {
        CAPTURE(i);
        const RayBatch one = rays.batch(i, 1);
        const Nearest alone = nearest(tree, one);
        CHECK((alone.t[0] == near.t[i] && alone.id[0] == near.id[i]));
        CHECK(constant(tree, one, 0.7f, 1e-3f).crossings[0] == through.crossings[i]);
        CHECK(coloured(tree, one, 1e-3f)[0] == colours[i]);
    }
}

TEST_CASE("coloured transmittance is the product over the crossings, and stops below the cutoff only") {
    const Hair hair = clumped_hair(3000, 9);
    const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
    const Rays rays = mixed_rays(3000, Vec3(0), 10);
    const Crossings listed = crossings(tree, rays.batch(), Isa::automatic);
    const std::vector<Rgb> all = coloured(tree, rays.batch(), 0);
    constexpr float kCutoff = 0.2f;
    const std::vector<Rgb> stopped = coloured(tree, rays.batch(), kCutoff);
    const Attenuation attenuation = some_attenuation();
    for (size_t i = 0; i < rays.size(); ++i) {
        CAPTURE(i);
        DVec3 depth(0);
        for (uint64_t k = listed.first[i]; k < listed.first[i + 1]; ++k) {
            const DVec3 axis = normalize(DVec3(hair.view().end(listed.id[k])) - DVec3(hair.view().start(listed.id[k])));
            const DVec3 d = normalize(DVec3(rays.dx[i], rays.dy[i], rays.dz[i]));
            depth += DVec3(attenuation.depth(listed.id[k], float(std::abs(dot(axis, d)))));
        }
        for (int c = 0; c < 3; ++c) {
            CHECK(std::abs(double(all[i][c]) - std::exp(-depth[c])) <= 1e-5);
            if (max_component(all[i]) >= kCutoff) CHECK(stopped[i][c] == all[i][c]);
        }
        CHECK((max_component(all[i]) < kCutoff) == (max_component(stopped[i]) < kCutoff));
    }
}

TEST_CASE("skipped segments are not met, all others are") {
    const Hair hair = clumped_hair(3000, 11);
    const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
    Rays rays = mixed_rays(2000, Vec3(0), 12);
    const Crossings all = crossings(tree, rays.batch(), Isa::automatic);
    for (size_t i = 0; i < rays.size(); ++i) {
        const bool none = all.first[i] == all.first[i + 1];
        rays.skip_first.push_back(none ? 0 : all.id[all.first[i]]);
        rays.skip_last.push_back(rays.skip_first.back() + uint32_t(i % 3));
    }
    const Crossings rest = crossings(tree, rays.batch(), Isa::automatic);
    const Nearest near = nearest(tree, rays.batch());
    for (size_t i = 0; i < rays.size(); ++i) {
        CAPTURE(i);
        std::vector<uint32_t> expected;
        for (uint64_t k = all.first[i]; k < all.first[i + 1]; ++k)
            if (all.id[k] < rays.skip_first[i] || all.id[k] > rays.skip_last[i]) expected.push_back(all.id[k]);
        CHECK(std::vector<uint32_t>(rest.id.begin() + long(rest.first[i]), rest.id.begin() + long(rest.first[i + 1])) ==
              expected);
        if (near.id[i] != kNone) CHECK((near.id[i] < rays.skip_first[i] || near.id[i] > rays.skip_last[i]));
    }
}

TEST_CASE("a straight strand is crossed once everywhere, at its joints too") {
    const Vec3 ways[] = {Vec3(1, 0, 0), normalize(Vec3(1, 2, -0.7f))};
    for (const Vec3& way : ways) {
        CAPTURE(way.y);
        Hair hair;
        Dice dice(13);
        std::vector<Vec3> corners{Vec3(-4, 0, 0)};
        for (int i = 0; i < 8; ++i) corners.push_back(corners.back() + (0.5f + dice.unit()) * way);
        hair.add_strand(corners, 0.1f);
        const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
        const Frame frame = frame_about(way);
        Rays rays;
        for (int i = 0; i < 20000; ++i) {
            const Vec3 on_axis = corners[size_t(1 + dice.below(7))] + (i % 2 ? 0.0f : 0.2f * dice.both()) * way;
            const float angle = 2 * kPi * dice.unit(), tilt = 0.7f * dice.both();
            const Vec3 side = -std::sin(angle) * frame.x + std::cos(angle) * frame.y;
            const Vec3 d = tilt * way + std::cos(angle) * frame.x + std::sin(angle) * frame.y;
            rays.add(on_axis + 0.09f * dice.both() * side - 5.0f * d, d);
        }
        size_t wrong = 0;
        for (const uint32_t crossings : constant(tree, rays.batch(), 0.5f, 0).crossings) wrong += crossings != 1;
        // start + (end - start) is not always end in single precision, and off the axes rounding bends the strand by
        // 1e-7: of rays aimed at a joint to the last bit one in a hundred may see either.
        CHECK(wrong <= rays.size() / 2 / (way.y == 0 ? 500 : 50));
    }
}

TEST_CASE("at a bend the open wedge only is lost, and nearest shows no crack") {
    Hair hair;
    hair.add_strand({Vec3(-1, 0, 0), Vec3(0, 0, 0), Vec3(0.9f, 0.4f, 0)}, 0.1f);
    const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
    Rays rays;
    for (int i = -90; i <= 90; ++i)
        for (int j = -90; j <= 90; ++j) rays.add(Vec3(0.001f * float(i), 0.001f * float(j), 1), Vec3(0, 0, -1));
    const Constant through = constant(tree, rays.batch(), 0.5f, 0);
    const Nearest near = nearest(tree, rays.batch());
    for (size_t i = 0; i < rays.size(); ++i) {
        const double x = rays.ox[i], y = rays.oy[i];
        CAPTURE(x);
        CAPTURE(y);
        const bool first = x < 0 && x >= -1;
        const double along = (x * 0.9 + y * 0.4) / (0.9 * 0.9 + 0.4 * 0.4);
        const double across = std::abs(x * 0.4 - y * 0.9) / std::hypot(0.9, 0.4);
        const bool second = along >= 0 && along < 1 && across <= 0.1;
        if (std::abs(x) > 1e-5 && std::abs(along) > 1e-5 && std::abs(across - 0.1) > 1e-4 &&
            std::abs(std::abs(y) - 0.1) > 1e-4)
            CHECK(through.crossings[i] == uint32_t(first) + uint32_t(second));
        if (std::hypot(x, y) < 0.0999) CHECK(near.id[i] != kNone);
    }
}

TEST_CASE("radii that vary along a segment narrow it in proportion") {
    const KdTree tree = one_hair(Vec3(0), Vec3(10, 0, 0), 0.2f, 0.0f);
    for (const float u : {0.1f, 0.5f, 0.9f}) {
        const float radius = 0.2f * (1 - u);
        for (const float side : {-1.01f, -0.99f, 0.5f, 0.99f, 1.01f}) {
            CAPTURE(u);
            CAPTURE(side);
            const Nearest hit = nearest(tree, single(Vec3(10 * u, side * radius, 3), Vec3(0, 0, -2)).batch());
            CHECK((hit.id[0] != kNone) == (std::abs(side) < 1));
            if (hit.id[0] == kNone) continue;
            CHECK(hit.t[0] == doctest::Approx(1.5).epsilon(1e-6));
            CHECK(hit.u[0] == doctest::Approx(u).epsilon(1e-5));
            // normalize(cross((0, 0, -1), (1, 0, 0))) is -y.
            CHECK(hit.h[0] == doctest::Approx(-side).epsilon(1e-4));
        }
    }
}

TEST_CASE("the interval of a ray holds its near end and not its far one") {
    const KdTree tree = one_hair(Vec3(-1, 0, 0), Vec3(1, 0, 0), 0.25f, 0.25f);
    const Vec3 o(0, 0, 4), d(0, 0, -1);
    CHECK(nearest(tree, single(o, d, 4, 5).batch()).t[0] == 4);
    CHECK(nearest(tree, single(o, d, 3, 4).batch()).id[0] == kNone);
    CHECK(constant(tree, single(o, d, 4, 5).batch(), 0.5f, 0).crossings[0] == 1);
    CHECK(constant(tree, single(o, d, 3, 4).batch(), 0.5f, 0).crossings[0] == 0);
    CHECK(nearest(tree, single(Vec3(0, 0.125f, 0), Vec3(0, 0, -1)).batch()).t[0] == 0);
}

TEST_CASE("rays without direction, length or number meet nothing") {
    const KdTree tree = one_hair(Vec3(-1, 0, 0), Vec3(1, 0, 0), 0.25f, 0.25f);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    Rays rays;
    rays.add(Vec3(0), Vec3(0));
    rays.add(Vec3(nan, 0, 0), Vec3(0, 0, 1));
    rays.add(Vec3(0), Vec3(0, nan, 1));
    rays.add(Vec3(kInfinity, 0, 0), Vec3(-1, 0, 0));
    rays.add(Vec3(0, 0, 1), Vec3(0, 0, -kInfinity));
    rays.add(Vec3(0, 0, 1), Vec3(0, 0, -1), nan);
    rays.add(Vec3(0, 0, 1), Vec3(0, 0, -1), 0, nan);
    rays.add(Vec3(0, 0, 1), Vec3(0, 0, -1), 2, 0);
    for (const uint32_t id : nearest(tree, rays.batch()).id) CHECK(id == kNone);
    for (const uint32_t crossings : constant(tree, rays.batch(), 0.5f, 0).crossings) CHECK(crossings == 0);
    CHECK(nearest(tree, single(Vec3(0, 0, 1), Vec3(0, 0, -1e-42f), -kInfinity).batch()).id[0] == 0);
    CHECK(nearest(tree, single(Vec3(0, 0, 1), Vec3(0, -0.0f, -1e38f)).batch()).id[0] == 0);
}

TEST_CASE("an empty tree is met nowhere") {
    const KdTree tree = build_segment_tree(SegmentView{}, AccelOptions{});
    const Rays rays = mixed_rays(10, Vec3(0), 14);
    for (const uint32_t id : nearest(tree, rays.batch()).id) CHECK(id == kNone);
    for (const float t : constant(tree, rays.batch(), 0.5f, 0).transmittance) CHECK(t == 1);
    for (const Rgb& t : coloured(tree, rays.batch(), 0)) CHECK(t == Rgb(1));
    CHECK(crossings(tree, rays.batch(), Isa::automatic).first == std::vector<uint64_t>(11, 0));
}
