// SPDX-License-Identifier: MIT
#include "gather/projection/far_hair.h"

#include "gather/projection/probe_grid.h"
#include "gather/projection/viewpoints.h"
#include "tests/projection_support.h"

using namespace tress;
using namespace tress::test;

namespace {

/// Segments of half the hair's size, which many cubes of the grid cut, and leaves larger and smaller than these.
ProjectedHair long_hair(float leaf_side, const Attenuation& attenuation = gray_fiber()) {
    Options options = without_gap();
    options.projection.leaf = 4;
    options.projection.cube = leaf_side;
    options.projection.opening = 0.3f;  // down to the pieces
    return projected(random_hair(1500, 1, 0.004f, 11), attenuation, ProjectionDetail::tree, options);
}

ProbeCube cube_of(const ProjectedHair& hair, int across, const Vec3& place) {
    return cube_at(make_probe_grid(hair_cube(bounds(hair.segments())), across), place);
}

Viewpoint at_corner(const ProbeCube& cube, int corner) {
    return {cube.corner(corner), random_frame(hash(3, uint64_t(corner))), Dome::sphere, {}};
}

FarHair far_hair(const ProjectedHair& hair, const ProbeCube& cube, int corner, Isa isa = Isa::automatic) {
    ProjectionScratch scratch;
    return find_far_hair(hair.projection, at_corner(cube, corner), cube.grid.size, isa, scratch);
}

std::vector<Rgb> through_near_and_far(const ProjectedHair& hair, const Viewpoint& from, const FarHair& far,
                                      Isa isa = Isa::automatic) {
    ProjectionScratch scratch;
    CellLight light;
    project_near(hair.projection, from, {}, far, isa, scratch);
    find_light(hair.projection, from, isa, scratch, light);
    return cells_of(light);
}

}  // namespace

TEST_CASE("packed depths let through what depths do, within a part in 500") {
    const auto depth_of = unpacked_depths();
    for (int i = 0; i < 4000; ++i) {
        const float depth = 0.01f * float(i);
        const PackedDepth packed = pack_depth(Rgb(depth, 0, 2 * depth));
        CHECK(std::abs(std::exp(-depth_of[packed.bits & 1023]) - std::exp(-depth)) < 0.002f);
        CHECK(depth_of[packed.bits >> 10 & 1023] == 0);
        CHECK(std::abs(std::exp(-depth_of[packed.bits >> 20 & 1023]) - std::exp(-2 * depth)) < 0.002f);
    }
}

// Cubes of 0.06 are smaller than those of either grid, cubes of 0.7 are larger than those of the finer one: then pieces
// of leaves are cut at the faces of the near box. Beside packing, the steps of what is cut
// fall elsewhere by a quarter of a cell: of the light in a cell, by a few per cent.
TEST_CASE("seen from a corner, near hair and far hair together are all hair, and none counts twice") {
    for (const float leaf_side : {0.06f, 0.7f})
        for (const int across : {8, 16}) {
            const ProjectedHair hair = long_hair(leaf_side);
            const ProbeCube cube = cube_of(hair, across, Vec3(0.1f, -0.2f, 0.3f));
            for (int corner = 0; corner < 8; ++corner) {
                const Viewpoint from = at_corner(cube, corner);
                const FarHair far = far_hair(hair, cube, corner);
                CAPTURE(leaf_side);
                CAPTURE(across);
                CAPTURE(corner);
                CHECK_FALSE(far.near.empty());
                const std::vector<Rgb> whole = seen(hair, from), both = through_near_and_far(hair, from, far);
                CHECK(mean_of(both) == doctest::Approx(mean_of(whole)).epsilon(0.002));
                CHECK(mean_difference(both, whole) < 0.01);
            }
        }
}

TEST_CASE("far hair that stops each colour by its own share is all hair with the near, in each colour") {
    const ProjectedHair hair = long_hair(0.06f, even_fiber({0.2f, 1, 3}));
    const ProbeCube cube = cube_of(hair, 8, Vec3(0.1f, -0.2f, 0.3f));
    const Viewpoint from = at_corner(cube, 2);
    const std::vector<Rgb> whole = seen(hair, from), both = through_near_and_far(hair, from, far_hair(hair, cube, 2));
    REQUIRE(both.size() == whole.size());
    DVec3 sum(0), off(0), difference(0);
    for (size_t i = 0; i < whole.size(); ++i) {
        sum += DVec3(whole[i]), off += DVec3(both[i]) - DVec3(whole[i]);
        difference += abs(DVec3(both[i]) - DVec3(whole[i])) / double(whole.size());
    }
    CHECK(sum.x > 1.1 * sum.y);
    CHECK(sum.y > 1.1 * sum.z);
    for (int c = 0; c < 3; ++c) {
        CAPTURE(c);
        CHECK(std::abs(off[c]) < 0.002 * sum[c]);
        CHECK(difference[c] < 0.01);
    }
}

// Depths of far hair alone, against the formula: with the hair of the near box cut away by hand.
TEST_CASE("far hair is what is outside the box about the corner, and no more") {
    const ProjectedHair hair = long_hair(0.06f);
    const ProbeCube cube = cube_of(hair, 8, Vec3(0));
    const FarHair far = far_hair(hair, cube, 0);
    const Vec3 middle = hair.projection.tree.origin + far.near_box.center;
    std::vector<Cone> outside;
    const SegmentView segments = hair.segments();
    for (uint32_t s = 0; s < segments.size(); ++s) {
        constexpr int kParts = 400;
        const auto place = [&](int i) { return glm::mix(segments.start(s), segments.end(s), float(i) / kParts); };
        const auto is_outside = [&](int i) {
            return max_component(abs(0.5f * (place(i) + place(i + 1)) - middle)) > far.near_box.half;
        };
        for (int i = 0; i < kParts; ++i) {
            if (!is_outside(i)) continue;
            const int first = i;
            while (i + 1 < kParts && is_outside(i + 1)) ++i;
            outside.push_back({place(first), place(i + 1), 0.004f, 0.004f});
        }
    }
    const ProjectedHair rest = projected(strands_of(outside), gray_fiber(), ProjectionDetail::all, without_gap());
    const std::vector<Rgb> exact = expected(rest, at_corner(cube, 0), 32);
    const auto depth_of = unpacked_depths();
    std::vector<Rgb> found;
    for (const PackedDepth& depth : far.depth) found.push_back(Rgb(std::exp(-depth_of[depth.bits & 1023])));
    CHECK(mean_of(found) == doctest::Approx(mean_of(exact)).epsilon(0.002));
    CHECK(mean_difference(found, exact) < 0.01);
}

// A corner sees other hair in a direction than the place does: that is noise of depths, and the mean of exponentials is
// larger for it. It falls with the grid; pictures have four times as many cubes across.
TEST_CASE("between corners, their mean by weight is nearly what a point sees") {
    const ProjectedHair hair = long_hair(0.06f);
    double sum = 0, exact = 0, squares = 0;
    constexpr int kPlaces = 40;
    for (uint64_t i = 0; i < kPlaces; ++i) {
        const Vec3 place = 1.2f * Vec3(random(i, 0), random(i, 1), random(i, 2)) - 0.6f;
        const ProbeCube cube = cube_of(hair, 32, place);
        double mean = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const Viewpoint from{place, at_corner(cube, corner).frame, Dome::sphere, {}};
            mean +=
                double(cube.weight(corner)) * mean_of(through_near_and_far(hair, from, far_hair(hair, cube, corner)));
        }
        const double whole = mean_of(seen(hair, {place, random_frame(i), Dome::sphere}));
        sum += mean, exact += whole, squares += square(mean - whole);
    }
    CHECK(sum == doctest::Approx(exact).epsilon(0.01));
    CHECK(std::sqrt(squares / kPlaces) < 0.01 * exact / kPlaces);
}

TEST_CASE("a point's own fiber is left out of the hair near it") {
    const ProjectedHair hair = long_hair(0.06f);
    const SegmentView segments = hair.segments();
    int tried = 0;
    for (uint32_t s = 0; s < segments.size(); ++s) {
        const Vec3 place = 0.5f * (segments.start(s) + segments.end(s));
        const ProbeCube cube = cube_of(hair, 4, place);
        const FarHair far = far_hair(hair, cube, 0);
        const Vec3 middle = hair.projection.tree.origin + far.near_box.center;
        const auto inside = [&](const Vec3& p) { return max_component(abs(p - middle)) < far.near_box.half; };
        if (!inside(segments.start(s)) || !inside(segments.end(s)) || tried == 5) continue;
        ++tried;
        const Viewpoint from = at_corner(cube, 0);
        ProjectionScratch scratch;
        CellLight light;
        project_near(hair.projection, from, {s, s, {}}, far, Isa::automatic, scratch);
        find_light(hair.projection, from, Isa::automatic, scratch, light);
        CHECK(mean_of(cells_of(light)) > mean_of(through_near_and_far(hair, from, far)));
        CHECK(mean_of(cells_of(light)) == doctest::Approx(mean_of(seen(hair, from, {s, s, {}}))).epsilon(0.002));
    }
    CHECK(tried == 5);
}

TEST_CASE("far hair is the same on every instruction set") {
    const ProjectedHair hair = long_hair(0.06f);
    const ProbeCube cube = cube_of(hair, 8, Vec3(0.2f));
    const FarHair first = far_hair(hair, cube, 5);
    const Viewpoint from{Vec3(0.2f), kUpright, Dome::sphere, {}};
    for (const Isa isa : supported_isas()) {
        CAPTURE(isa_name(isa));
        const FarHair far = far_hair(hair, cube, 5, isa);
        REQUIRE(far.depth.size() == first.depth.size());
        for (size_t i = 0; i < far.depth.size(); ++i) REQUIRE(far.depth[i].bits == first.depth[i].bits);
        CHECK(through_near_and_far(hair, from, far, isa) == through_near_and_far(hair, from, first, Isa::scalar));
    }
}
