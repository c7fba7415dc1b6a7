// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include "core/error.h"
#include "tools/check/support/small_scenes.h"

using namespace tress;
using namespace tress::test;

TEST_CASE("a scene far from the origin assembles to the same coordinates as one at the origin") {
    PlacedHair near = upright_fibers({{0, 0}, {1, 0.5f}}, 2, 0.01f, white_fiber()), far = near;
    far.placement.m[3] = 1e6;
    far.placement.m[7] = -2e6;
    Camera camera, far_camera = camera;
    far_camera.from += DVec3(1e6, -2e6, 0);
    far_camera.to += DVec3(1e6, -2e6, 0);
    const Scene a = assemble({near}, {}, {}, camera), b = assemble({far}, {}, {}, far_camera);
    CHECK(a.hair.x == b.hair.x);
    CHECK(a.hair.y == b.hair.y);
    CHECK(a.hair.z == b.hair.z);
    CHECK(a.camera.from == b.camera.from);
}

TEST_CASE("hair thinner than its coordinates resolve is refused") {
    PlacedHair hair = upright_fibers({{1e6f, 0}}, 1, 1e-3f, white_fiber());
    CHECK_THROWS_WITH_AS(assemble({hair}, {}, {}, {}), doctest::Contains("4 ulp"), InputError);
}

TEST_CASE("radii and colours are stored a point only where objects differ or have them") {
    const PlacedHair thin = upright_fibers({{0, 0}}, 1, 0.01f, white_fiber());
    PlacedHair thick = upright_fibers({{1, 0}}, 1, 0.02f, white_fiber()), coloured = thin;
    coloured.strands.color.assign(coloured.strands.points(), Rgb(0.8f, 0.5f, 0.2f));

    const Scene same = assemble({thin, thin}, {}, {}, {});
    CHECK(same.hair.radius.empty());
    CHECK(same.hair.constant_radius == 0.01f);
    CHECK(same.sigma_a.empty());

    const Scene two = assemble({thin, thick}, {}, {}, {});
    CHECK(two.hair.radius == std::vector<float>{0.01f, 0.01f, 0.02f, 0.02f});

    const Scene with_colour = assemble({thin, coloured}, {}, {}, {});
    REQUIRE(with_colour.sigma_a.size() == 4);
    CHECK(with_colour.sigma_a[0] == thin.fiber.parameters.sigma_a);
    CHECK(with_colour.sigma_a[2] == sigma_a_from_color(Rgb(0.8f, 0.5f, 0.2f), thin.fiber.parameters.beta_n));
    CHECK(with_colour.hair.color.empty());
}

TEST_CASE("a mirror keeps triangles and normals facing outwards") {
    PlacedMesh mesh = square(1, Rgb(1));
    mesh.mesh.normal.assign(4, Vec3(0, 0, 1));
    mesh.placement.m[0] = -1;  // x -> -x: the square maps to itself
    const Scene scene = assemble({}, {mesh}, {}, {});
    for (size_t t = 0; t < scene.mesh.triangles(); ++t) {
        const auto [a, b, c] = scene.mesh.triangle(t);
        CHECK(cross(b - a, c - a).z > 0);
    }
    for (const Vec3& n : scene.mesh.normal) CHECK(n == Vec3(0, 0, 1));
}

TEST_CASE("segments know their fiber") {
    const Scene scene = assemble(
        {upright_fibers({{0, 0}, {1, 0}}, 1, 0.1f, white_fiber()), upright_fibers({{2, 0}}, 1, 0.1f, white_fiber())},
        {}, {}, {});
    REQUIRE(scene.segments.point.size() == 3);
    CHECK(fiber_of(scene, 0) == 0);
    CHECK(fiber_of(scene, 1) == 0);
    CHECK(fiber_of(scene, 2) == 1);
}

TEST_CASE("a colour with a channel at 0 absorbs all of it and keeps its hair") {
    PlacedHair red = upright_fibers({{0, 0}}, 1, 0.1f, white_fiber());
    red.strands.color.assign(red.strands.points(), Rgb(1, 0, 0));
    const Scene scene = assemble({red}, {}, {}, {});
    CHECK(scene.segments.point.size() == 1);
    CHECK(scene.segments.dropped == 0);
    CHECK(std::isinf(scene.sigma_a[0].y));
}

TEST_CASE("what a ray leaves by identity reaches some radii along a finely cut strand, and no farther") {
    PlacedHair fine;
    fine.strands.constant_radius = 1;
    fine.strands.first = {0, 101, 202};
    for (int strand = 0; strand < 2; ++strand)
        for (int i = 0; i <= 100; ++i) fine.strands.add_point({50.0f * float(strand), float(i), 0});
    fine.fiber = white_fiber();
    const Scene scene = assemble({fine}, {}, {}, {});
    const SegmentView segments = view(scene.hair, scene.segments);
    const SegmentRange middle = own_strand(segments, 50), end = own_strand(segments, 99),
                       next = own_strand(segments, 100);
    CHECK(middle.first == 50 - uint32_t(kOwnStrandRadii));
    CHECK(middle.last == 50 + uint32_t(kOwnStrandRadii));
    CHECK(end.last == 99);
    CHECK(next.first == 100);
}

TEST_CASE("a strand goes on where a segment was too short to be kept, and breaks where a point is not finite") {
    StrandSet strands;
    strands.constant_radius = 0.01f;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float x : {0.0f, 1.0f, 1.0f, 2.0f, nan, 3.0f, 4.0f}) strands.add_point({x, 0, 0});
    strands.first = {0, uint32_t(strands.points())};
    const SegmentList list = list_segments(strands);
    const SegmentView segments = view(strands, list);
    REQUIRE(list.point == std::vector<uint32_t>{0, 2, 5});
    CHECK(list.dropped == 3);
    CHECK(joined(segments, 0, 1));
    CHECK_FALSE(joined(segments, 1, 2));
    CHECK(own_strand(segments, 0).last == 1);
    CHECK(own_strand(segments, 2).first == 2);
}
