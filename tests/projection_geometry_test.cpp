// SPDX-License-Identifier: MIT
#include "tests/projection_support.h"
#include "tools/check/support/cone_coverage.h"

using namespace tress;
using namespace tress::test;

namespace {

constexpr ProjectionDetail kDetails[] = {ProjectionDetail::all, ProjectionDetail::tree};
constexpr Dome kDomes[] = {Dome::sphere, Dome::hemisphere};

struct PlacedCone {
    std::string name;
    Cone cone;
};

/// About the point (0, 0, 0), whose pole is z and whose azimuths start at x.
const PlacedCone kThin[] = {{"over the pole", {{-1, 0.02f, 1}, {1, 0.03f, 1.1f}, 0.02f, 0.02f}},
                            {"across the horizon", {{1, 0.3f, -0.7f}, {1.1f, 0.2f, 0.8f}, 0.02f, 0.02f}},
                            {"across the seam of azimuth", {{1, -0.6f, 0.3f}, {1, 0.7f, 0.4f}, 0.02f, 0.02f}},
                            {"longer than 90 degrees", {{-1, 0.1f, 0.5f}, {1.2f, 0.2f, 0.5f}, 0.01f, 0.01f}},
                            {"longer than 170 degrees", {{-1, 0.02f, 0.03f}, {1, 0.02f, 0.02f}, 0.001f, 0.001f}},
                            {"nearly through it", {{-1, -0.5f, -0.2f}, {1, 0.502f, 0.2f}, 0.0002f, 0.0002f}},
                            {"small and far", {{30, 20, -10}, {30.3f, 20.5f, -10}, 0.1f, 0.1f}},
                            {"tapered", {{1, -0.6f, 0.3f}, {1, 0.7f, 0.4f}, 0.03f, 0.001f}}};

const PlacedCone kWide[] = {{"beside the pole", {{-1, 0.3f, 1}, {1, 0.2f, 0.8f}, 0.3f, 0.3f}},
                            {"across the horizon", {{1, 0.3f, -0.7f}, {1.1f, 0.2f, 0.8f}, 0.3f, 0.3f}},
                            {"tapered", {{1, -0.6f, 0.3f}, {1, 0.7f, 0.4f}, 0.3f, 0.02f}},
                            {"tapered the other way", {{-0.6f, 0.8f, -0.3f}, {0.7f, 0.9f, 0.2f}, 0.02f, 0.3f}}};

/// Half the sphere or nearly so is covered: its rim alone is a tenth of all cells.
const PlacedCone kAround[] = {{"touching", {{-1, 0.0105f, 0}, {0.7f, 0.0105f, 0.001f}, 0.01f, 0.01f}},
                              {"inside", {{-1, 0.006f, 0}, {0.7f, 0.002f, 0.001f}, 0.01f, 0.01f}},
                              {"close to the axis", {{-0.3f, 3e-4f, 0.2f}, {0.3f, 3e-4f, -0.2f}, 0.05f, 0.05f}}};
/// The tree knows pieces to 2^-16 of their cubes, and so not on which side of this axis the point is.
const PlacedCone kOnAxis = {"next to nothing from the axis",
                            {{-0.3f, 1e-5f, 0.2f}, {0.3f, 1e-5f, -0.2f}, 0.05f, 0.05f}};

constexpr int kFrames = 4;

/// Against the formula: the mean error of a cell, and the error of what is stopped in all, of itself, in the mean over
/// a few ways that the igloo may stand.
void check_cone(const PlacedCone& placed, ProjectionDetail detail, double most_error, double most_bias,
                float near = Options().projection.near) {
    Options options = without_gap();
    options.projection.near = near;
    const ProjectedHair hair = projected(strands_of({placed.cone}), gray_fiber(), detail, options);
    for (const Dome dome : kDomes) {
        CAPTURE(placed.name);
        CAPTURE(int(detail));
        CAPTURE(int(dome));
        CAPTURE(near);
        double stopped = 0, exact = 0;
        for (int i = 0; i < kFrames; ++i) {
            const Viewpoint from{Vec3(0), i == 0 ? kUpright : turned_about_z(kUpright, float(i)), dome};
            const std::vector<Rgb> cells = seen(hair, from), truth = expected(hair, from, 32);
            CHECK(all_within_unit(cells));
            CHECK(mean_difference(cells, truth) < most_error);
            stopped += (1 - mean_of(cells)) / kFrames;
            exact += (1 - mean_of(truth)) / kFrames;
        }
        CAPTURE(stopped);
        CAPTURE(exact);
        CHECK(std::abs(stopped - exact) < most_bias * exact + 1e-5);
    }
}

}  // namespace

// Half a step's place in its cell, a quarter of a cell, is lost at the rim of what a fiber covers. Parts of a thin
// fiber that share a cell count as if one were behind the other: of two of coverage x, x^2 is lost.
TEST_CASE("a thin segment stops in each cell what the formula says") {
    for (const ProjectionDetail detail : kDetails)
        for (const PlacedCone& placed : kThin) check_cone(placed, detail, 0.01, 0.04);
}

// Of 64 samples of a square an edge at any angle is right to 0.014 of it, two edges to 0.02; at most 30 of 512 cells
// see such a segment. All that it covers is right, but where it lies in a cell or none of its samples.
TEST_CASE("a thin segment whose samples are asked stops in each cell what the formula says") {
    for (const ProjectionDetail detail : kDetails)
        for (const PlacedCone& placed : kThin) check_cone(placed, detail, 0.003, 0.04, 0.01f);
}

// An edge across a square at any angle is right to 0.043 of it, and eight of a cell's 64 lie at an edge: 0.005 of such
// a cell, and few are.
TEST_CASE("a wide segment stops in each cell what the formula says") {
    for (const ProjectionDetail detail : kDetails)
        for (const PlacedCone& placed : kWide) check_cone(placed, detail, 0.001, 0.01);
    check_cone({"short", {{1, -0.1f, 0.3f}, {0.9f, 0.15f, 0.4f}, 0.3f, 0.3f}}, ProjectionDetail::all, 0.001, 0.01);
}

// The rim is a tenth of all cells: 0.0011. Pieces of a tree are known to 2^-16 of their cubes, here a tenth of the
// distance.
TEST_CASE("a segment about the point or next to it stops in each cell what the formula says") {
    for (const ProjectionDetail detail : kDetails)
        for (const PlacedCone& placed : kAround) check_cone(placed, detail, 0.002, 0.005);
    check_cone(kOnAxis, ProjectionDetail::all, 0.002, 0.005);
}

// The point lies off the segment's middle, where the tree cuts it: a part that ends at the point has no great circle.
TEST_CASE("a segment exactly through the point stops as much as one whose axis nearly meets the point") {
    const Vec3 half(0.3f, -0.2f, 0.1f), aside(0.001f, 0.0015f, 0);
    const Viewpoint from{Vec3(0), kUpright, Dome::sphere};
    for (const ProjectionDetail detail : kDetails) {
        CAPTURE(int(detail));
        const ProjectedHair through =
            projected(strands_of({{-1.3f * half, half, 0.05f, 0.05f}}), gray_fiber(), detail, without_gap());
        const ProjectedHair nearly = projected(strands_of({{aside - 1.3f * half, aside + half, 0.05f, 0.05f}}),
                                               gray_fiber(), detail, without_gap());
        const std::vector<Rgb> cells = seen(through, from);
        CHECK(all_within_unit(cells));
        CHECK(mean_of(cells) == doctest::Approx(mean_of(expected(nearly, from, 32))).epsilon(0.02));
    }
}

TEST_CASE("a segment cut exactly at the point gives cells within the unit interval") {
    const Vec3 half(0.3f, -0.2f, 0.1f);
    const ProjectedHair hair =
        projected(strands_of({{-half, half, 0.05f, 0.05f}}), gray_fiber(), ProjectionDetail::tree, without_gap());
    CHECK(all_within_unit(seen(hair, {Vec3(0), kUpright, Dome::sphere})));
}

// Depth x + x^2 of a depth of a thousandth is linear to a thousandth. The tree takes cubes of which a segment's
// share is at most sqrt(3) / 12.7 of its distance long, as seen from its middle: L^2 / 2 d^2, 0.9 % at worst.
TEST_CASE("a segment covers its exact solid angle at every distance") {
    constexpr float kDepth = 1e-3f;
    const Attenuation faint = even_fiber(Rgb(kDepth));
    Options options = without_gap();
    options.projection.opening = 0.5f;
    for (const ProjectionDetail detail : kDetails)
        for (uint64_t i = 0; i < 1000; ++i) {
            const auto [cone, from] = random_sight(hash(31, i));
            const ProjectedHair hair = projected(strands_of({cone}), faint, detail, options);
            const double exact = solid_angle(cone, from.position);
            const double found = projected_solid_angle(hair, from, double(kDepth));
            CAPTURE(int(detail));
            CAPTURE(i);
            CAPTURE(length(from.position));
            CAPTURE(cone.radius_a);
            CHECK(std::abs(found - exact) < 0.01 * exact);
        }
}

// More rows than are looked at before those near are drawn. Sixteen of them lost or counted twice, in the mean, are
// twice the bound; splats that are each within 1 % of themselves err to either side.
TEST_CASE("seventy thousand segments cover the sum of their exact solid angles") {
    const StrandSet strands = random_hair(70000, 0.1f, 1e-4f, 8);
    const ProjectedHair hair = projected(strands, even_fiber(Rgb(kFaint)), ProjectionDetail::all, without_gap());
    const SegmentView segments = hair.segments();
    for (const Vec3& position : {Vec3(0), Vec3(0.9f, 0.3f, -0.2f)}) {
        double exact = 0;
        for (uint32_t s = 0; s < segments.size(); ++s)
            exact += solid_angle({segments.start(s), segments.end(s), segments.start_radius(s), segments.end_radius(s)},
                                 position);
        for (const Isa isa : supported_isas()) {
            const Viewpoint from{position, random_frame(9), Dome::sphere};
            const double found = projected_solid_angle(hair, from, double(kFaint), isa);
            CAPTURE(isa_name(isa));
            CAPTURE(position.x);
            CAPTURE(exact);
            CHECK(std::abs(found / exact - 1) < 1e-4);
        }
    }
}

// A splat is one cell's, and segments differ in width: one in another's cell is seen in two. Its solid angle is right
// to a few roundings and, of 1 / distance^2, 2e-5.
TEST_CASE("far hair covers the cell of its direction") {
    constexpr float kDistance = 100, kLength = 0.01f;
    for (const int cells : {64, 256, 1000}) {
        Options options = without_gap();
        options.projection.cells = cells;
        const Igloo igloo = make_igloo(uint32_t(cells));
        std::vector<Cone> cones;
        for (uint32_t cell = 0; cell < igloo.cells_of(Dome::sphere); ++cell) {
            const Vec2 u(0.05f + 0.9f * random(cell, 0), 0.05f + 0.9f * random(cell, 1));
            const Vec3 w = direction_in(igloo, cell, u), half = 0.5f * kLength * frame_about(w).x;
            const float radius = 1e-4f * (1 + float(cell) / float(cells));
            cones.push_back({kDistance * w - half, kDistance * w + half, radius, radius});
        }
        const ProjectedHair hair =
            projected(strands_of(cones), even_fiber(Rgb(kFaint)), ProjectionDetail::all, options);
        for (const Isa isa : supported_isas()) {
            const std::vector<double> covered = coverage(hair, {Vec3(0), kUpright, Dome::sphere}, double(kFaint), isa);
            int wrong = 0;
            for (size_t cell = 0; cell < covered.size(); ++cell) {
                const double share = solid_angle(cones[cell], Vec3(0)) / double(igloo.solid_angle());
                wrong += !(std::abs(covered[cell] - share) < 1e-4 * share);
            }
            CAPTURE(cells);
            CAPTURE(isa_name(isa));
            CHECK(wrong == 0);
        }
    }
}

// Fibers side by side, one behind another, and across each other, as next to a point: what their product over a cell
// says is off by up to 0.2 of it. Two edges of each fiber, by 64 samples, leave 0.02 of a cell, of those that see them.
TEST_CASE("fibers next to a point hide each other where they do") {
    const auto at = [](float x, float tilt, float far, float r) {
        return Cone{far * Vec3(x, -1, 1), far * Vec3(x + tilt, 1, 1), far * r, far * r};
    };
    const std::vector<std::vector<Cone>> bundles = {
        {at(0, 0, 1, 0.04f), at(0, 0, 1.5f, 0.04f), at(0, 0, 2, 0.04f)},              // one behind another
        {at(0, 0, 1, 0.04f), at(0.081f, 0, 1, 0.04f), at(0.162f, 0, 1, 0.04f)},       // side by side
        {at(0, 0.2f, 1, 0.04f), at(0.2f, -0.2f, 1.3f, 0.03f), at(0.1f, 0, 2, 0.05f)}  // across
    };
    for (const ProjectionDetail detail : kDetails)
        for (size_t b = 0; b < bundles.size(); ++b)
            for (const float depth : {0.5f, 50.0f}) {
                CAPTURE(int(detail));
                CAPTURE(b);
                CAPTURE(depth);
                const ProjectedHair hair =
                    projected(strands_of(bundles[b]), even_fiber(Rgb(depth)), detail, without_gap());
                const Viewpoint from{Vec3(0), random_frame(9), Dome::sphere};
                const std::vector<Rgb> cells = seen(hair, from), truth = expected(hair, from, 32);
                CHECK(all_within_unit(cells));
                CHECK(mean_difference(cells, truth) < 0.002);
                CHECK(mean_of(cells) == doctest::Approx(mean_of(truth)).epsilon(0.001));
            }
}

TEST_CASE("a hemisphere is the upper half of the sphere") {
    for (const ProjectionDetail detail : kDetails) {
        CAPTURE(int(detail));
        const ProjectedHair hair = projected(random_hair(500, 0.5f, 0.005f, 3), gray_fiber(), detail, without_gap());
        const Frame frame = random_frame(4);
        std::vector<Rgb> sphere = seen(hair, {Vec3(0.1f), frame, Dome::sphere});
        sphere.resize(sphere.size() / 2);
        // Depths are added in another order: a few roundings of sums of tens of terms.
        CHECK(mean_difference(seen(hair, {Vec3(0.1f), frame, Dome::hemisphere}), sphere) < 1e-6);
    }
}

// What a mean of depths loses in a cell depends on which hair shares it; so thin is the hair that this is little.
TEST_CASE("turning the cells about thin hair changes the mean transmittance by less than a thousandth") {
    for (const ProjectionDetail detail : kDetails)
        for (const Vec3& position : {Vec3(0), Vec3(0.9f, 0.3f, -0.2f), Vec3(0, 1, 3)}) {
            const ProjectedHair hair =
                projected(random_hair(4000, 0.5f, 0.0005f, 5), gray_fiber(), detail, without_gap());
            double least = 1, most = 0;
            for (uint64_t turn = 0; turn < 20; ++turn) {
                const double mean = mean_of(seen(hair, {position, random_frame(hash(6, turn)), Dome::sphere}));
                least = std::min(least, mean), most = std::max(most, mean);
            }
            CAPTURE(int(detail));
            CAPTURE(position.z);
            CAPTURE(most);
            CHECK(most - least < 1e-3);
        }
}
