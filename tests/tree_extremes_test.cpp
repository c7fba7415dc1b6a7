// SPDX-License-Identifier: MIT
// Stiff cases of hair queries: thin hair seen from far, rays along the axis, ten thousand layers.
#include <doctest/doctest.h>

#include "tools/check/support/one_hair.h"

using namespace tress;
using namespace tress::scenes;

TEST_CASE("thin hair seen from far away is hit where it should be") {
    const FarErrors near = far_errors(3e4, 100000), far = far_errors(3e5, 100000);
    MESSAGE("wrong at 3e4 radii: " << near.wrong << ", at 3e5: " << far.wrong << "; t off by " << near.t_error
                                   << " and " << far.t_error << " radii");
    CHECK(near.wrong <= 2e-4);
    CHECK(far.wrong <= 5e-3);
    CHECK(near.t_error <= 0.01);
}

TEST_CASE("no ray along the axis, through the tip or from inside a hair is lost") {
    Dice dice(22);
    Losses sum;
    for (int k = 0; k < 50; ++k) {
        const Hair hair = one_hair(dice);
        const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
        add_losses(hair, tree, rays_along(hair, 4000, dice), Isa::automatic, sum);
        add_losses(hair, tree, rays_through_tip(hair, 2000, dice), Isa::automatic, sum);
        add_losses(hair, tree, rays_from_within(hair, 2000, dice), Isa::automatic, sum);
    }
    CHECK(sum.rays == 400000);
    CHECK(sum.lost == 0);
    CHECK(sum.false_hits == 0);
    CHECK(sum.too_close < sum.rays / 1000);
}

TEST_CASE("a ray that starts inside a hair meets it where it passes the axis ahead, and nowhere behind") {
    const float radius = 0.1f;
    Hair hair;
    hair.add(Vec3(-1, 0, 0), Vec3(1, 0, 0), radius);
    const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
    Dice dice(23);
    Rays rays;
    for (int i = 0; i < 1000; ++i) rays.add(Vec3(0, 0, 0.09f * dice.both()), Vec3(0.3f * dice.both(), 0, -1));
    const Nearest found = nearest(tree, rays.batch());
    for (size_t i = 0; i < rays.size(); ++i) {
        CAPTURE(rays.oz[i]);
        CHECK((found.id[i] == 0) == (rays.oz[i] >= 0));
        if (found.id[i] == 0) CHECK(found.t[i] == doctest::Approx(rays.oz[i]).epsilon(1e-5));
    }
}

TEST_CASE("ten thousand layers are counted to the last") {
    constexpr int kLayers = 10000;
    Hair hair;
    for (int i = 0; i < kLayers; ++i) {
        const float z = 0.01f * float(i);
        hair.add(Vec3(-1, 0, z), Vec3(1, 0, z), 0.02f);
    }
    const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
    Rays rays;
    Dice dice(24);
    for (int i = 0; i < 200; ++i)
        rays.add(Vec3(0.5f * dice.both(), 0.01f * dice.both(), i % 2 ? -1.0f : 200.0f), Vec3(0, 0, i % 2 ? 1 : -1));
    for (const uint32_t crossings : constant(tree, rays.batch(), 0.999f, 0).crossings) CHECK(crossings == kLayers);
    constexpr uint32_t kFirstBelow = 6905;  // log(1e-3) / log(0.999) = 6904.3
    for (const uint32_t crossings : constant(tree, rays.batch(), 0.999f, 1e-3f).crossings)
        CHECK(crossings == kFirstBelow);
    Attenuation attenuation;
    attenuation.table.resize(1);
    attenuation.table[0].depth.assign(AttenuationTable::kRows, Rgb(1e-3f, 1e-4f, 1e-5f));
    std::vector<Rgb> through(rays.size());
    transmittance(tree, rays.batch(), attenuation, 0, through, Isa::automatic);
    for (const Rgb& t : through) {
        CHECK(t.x == doctest::Approx(std::exp(-10.0)).epsilon(1e-5));
        CHECK(t.y == doctest::Approx(std::exp(-1.0)).epsilon(1e-5));
        CHECK(t.z == doctest::Approx(std::exp(-0.1)).epsilon(1e-5));
    }
}

TEST_CASE("of many hairs at one place the one of the smallest number is nearest") {
    Hair hair;
    for (int i = 0; i < 5000; ++i) hair.add(Vec3(-1, 0.1f, 0.3f), Vec3(1, 0.2f, -0.3f), 0.05f);
    const KdTree tree = build_segment_tree(hair.view(), AccelOptions{});
    Rays rays;
    Dice dice(25);
    for (int i = 0; i < 100; ++i) rays.add(Vec3(0.5f * dice.both(), 0.15f, 3), Vec3(0, 0, -1));
    const Nearest found = nearest(tree, rays.batch());
    const Constant through = constant(tree, rays.batch(), 0.5f, 0);
    for (size_t i = 0; i < rays.size(); ++i) {
        CHECK(found.id[i] == 0);
        CHECK(through.crossings[i] == 5000);
    }
}
