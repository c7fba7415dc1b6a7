// SPDX-License-Identifier: MIT
// Which hair is projected, and in which colours.
#include "tests/projection_support.h"

using namespace tress;
using namespace tress::test;

namespace {

constexpr ProjectionDetail kDetails[] = {ProjectionDetail::all, ProjectionDetail::tree};

/// One absorption a segment.
Attenuation colored(const std::vector<Rgb>& sigma_a) {
    return {{}, {make_absorption_table(make_fiber({}))}, {}, sigma_a};
}

/// Whether a fiber leaves no trace to points on it, on its axis and on its surface.
void check_unseen(const StrandSet& strands, ProjectionDetail detail, int cells) {
    Options options = without_gap();
    options.projection.cells = cells;
    const ProjectedHair hair = projected(strands, gray_fiber(), detail, options);
    const SegmentView view = hair.segments();
    CAPTURE(int(detail));
    CAPTURE(cells);
    CAPTURE(view.size());
    for (uint32_t segment = 0; segment < view.size(); segment += uint32_t(std::max<size_t>(view.size() / 4, 1))) {
        const Unseen unseen = unseen_on(view, segment);
        REQUIRE((unseen.first == 0 && unseen.last + 1 == view.size()));
        const Vec3 middle = 0.5f * (view.start(segment) + view.end(segment));
        for (const Vec3& off : {Vec3(0), Vec3(0, 0, view.start_radius(segment))}) {
            CAPTURE(segment);
            CAPTURE(off.z);
            CHECK(all_one(seen(hair, {middle + off, random_frame(segment), Dome::sphere}, unseen)));
        }
    }
}

}  // namespace

TEST_CASE("where there is no hair everything is let through, exactly") {
    for (const ProjectionDetail detail : kDetails)
        for (const float gap : {0.0f, 1.0f}) {
            CAPTURE(int(detail));
            CAPTURE(gap);
            Options options;
            options.projection.gap = gap;
            const Viewpoint all_round{Vec3(0), random_frame(1), Dome::sphere}, up{Vec3(0), kUpright, Dome::hemisphere};
            CHECK(all_one(seen(projected({}, gray_fiber(), detail, options), all_round)));
            CHECK(all_one(seen(projected({}, even_fiber({1, 2, 3}), detail, options), all_round)));
            StrandSet below = random_hair(300, 0.5f, 0.02f, 2);
            for (float& z : below.z) z -= 1.3f;  // some next to the point's plane, some far below
            CHECK(all_one(seen(projected(below, gray_fiber(), detail, options), up)));
            CHECK(all_one(seen(projected(below, even_fiber({1, 2, 3}), detail, options), up)));
        }
}

TEST_CASE("a fiber that is not seen from a point leaves no trace there") {
    for (const ProjectionDetail detail : kDetails)
        for (const int cells : {4, 16, 256, 16384}) {
            check_unseen(straight_fiber(1, 1, 0.02f), detail, cells);
            check_unseen(straight_fiber(1, 100, 0.001f), detail, cells);
            check_unseen(straight_fiber(4, 0.08f, 0.02f), detail, cells);
        }
}

// More pieces than a leaf keeps, all within 16 radii of each other: cubes are not much larger than the fiber is wide.
TEST_CASE("a fiber cut into pieces shorter than its radius leaves no trace to itself") {
    for (const ProjectionDetail detail : kDetails)
        for (const int cells : {16, 256, 1024}) check_unseen(straight_fiber(60, 0.005f, 0.02f), detail, cells);
}

TEST_CASE("leaving out one of two fibers leaves what the other alone does") {
    const Cone first{{-1, 0.01f, 0.02f}, {1, 0.02f, 0.01f}, 0.01f, 0.01f};
    const Cone second{{0.3f, -1, 0.2f}, {0.2f, 1, 0.3f}, 0.01f, 0.02f};
    const Viewpoint from{Vec3(0), random_frame(7), Dome::sphere};
    for (const ProjectionDetail detail : kDetails) {
        CAPTURE(int(detail));
        Options options = without_gap();
        options.projection.opening = 0.1f;  // all pieces are drawn, so that no cube hides which they are
        const ProjectedHair both = projected(strands_of({first, second}), gray_fiber(), detail, options);
        const ProjectedHair alone = projected(strands_of({second}), gray_fiber(), detail, options);
        const std::vector<Rgb> cells = seen(both, from, {0, 0, {}});
        CHECK(mean_of(cells) < 0.99);
        // Its pieces are cut elsewhere by another tree: parts of it are placed up to half a step elsewhere.
        CHECK(mean_difference(cells, seen(alone, from)) < (detail == ProjectionDetail::all ? 1e-6 : 5e-3));
        CHECK(mean_difference(cells, seen(both, from)) > 1e-3);
    }
}

// Steps of a hundred-and-twenty-eighth of what is absorbed, within the error of a gray segment. From next to them,
// where they are arcs, from where two splats stand for one and four for the other, and from where one does for each.
TEST_CASE("fibers of different colours let their own colours through") {
    const Attenuation colors = colored({{0.05f, 0.5f, 5}, {5, 0.5f, 0.05f}});
    const Viewpoint from{Vec3(0), kUpright, Dome::sphere};
    for (const ProjectionDetail detail : kDetails)
        for (const float far : {1.0f, 4.0f, 20.0f}) {
            CAPTURE(int(detail));
            CAPTURE(far);
            const float r = 0.01f * far;
            const StrandSet two = strands_of({{{far, -0.6f, 0.3f * far}, {far, 0.7f, 0.3f * far + 0.1f}, r, r},
                                              {{-1, 0.02f, far}, {1, 0.03f, far + 0.1f}, r, r}});
            const ProjectedHair hair = projected(two, colors, detail, without_gap());
            CHECK(!hair.projection.opacity.gray);
            const std::vector<Rgb> cells = seen(hair, from), truth = expected(hair, from, 32);
            CHECK(all_within_unit(cells));
            double error[3] = {};
            int reddish = 0, bluish = 0;
            for (size_t i = 0; i < cells.size(); ++i) {
                for (int c = 0; c < 3; ++c)
                    error[c] += std::abs(double(cells[i][c] - truth[i][c])) / double(cells.size());
                reddish += cells[i].x > cells[i].z + 0.02f, bluish += cells[i].z > cells[i].x + 0.02f;
            }
            for (const double e : error) CHECK(e < 0.01);
            CHECK(reddish > (far == 1 ? 5 : 0));
            CHECK(bluish > (far == 1 ? 5 : 0));
        }
}

TEST_CASE("less than no gap takes light away, but never more than there is") {
    const StrandSet strands = random_hair(500, 0.5f, 0.02f, 13);
    const Viewpoint from{Vec3(0.2f), random_frame(14), Dome::sphere};
    for (const ProjectionDetail detail : kDetails) {
        CAPTURE(int(detail));
        ProjectedHair hair = projected(strands, gray_fiber(), detail, without_gap());
        const std::vector<Rgb> without = seen(hair, from);
        hair.projection.at_hair.shares.gap = -1;
        const std::vector<Rgb> less = seen(hair, from);
        CHECK(all_within_unit(less));
        for (size_t i = 0; i < less.size(); ++i) CHECK(less[i].x <= without[i].x);
        CHECK(mean_of(less) < mean_of(without) - 0.001);
    }
}

TEST_CASE("shares of the gap to neighbours are added to each cell behind near hair, and of the scatter taken off") {
    const StrandSet strands = random_hair(500, 0.5f, 0.02f, 13);
    const Vec3 at(0.2f);
    for (const Dome dome : {Dome::sphere, Dome::hemisphere})
        for (const GapShares& shares : {GapShares{1, 0}, GapShares{0.3f, 1}, GapShares{1.5f, 0.5f}}) {
            CAPTURE(int(dome));
            CAPTURE(shares.scatter);
            const Viewpoint from{at, random_frame(14), dome};
            ProjectedHair hair = projected(strands, gray_fiber(), ProjectionDetail::all, without_gap());
            std::vector<Rgb> without = seen(hair, from);
            hair.projection.at_hair.shares = hair.projection.at_polygons.shares = shares;
            const std::vector<Rgb> with = seen(hair, from);
            const Igloo& igloo = hair.projection.igloo;
            ProjectionScratch scratch;
            project(hair.projection, hair.segments(), from, {}, Isa::automatic, scratch);
            std::vector<double> near;  // of hair next to the point, before the rest
            for (size_t i = 0; i < with.size(); ++i) {
                near.push_back(double(scratch.near.through(i, with.size(), false).c[0]));
                if (near[i] > 0) without[i] /= float(near[i]);
            }
            double largest = 0;
            for (size_t i = 0; i < with.size(); ++i) {
                const auto other = [&](size_t side) {
                    const auto cell = size_t(igloo.neighbor[side * 2 * igloo.cells + i]);
                    return cell < with.size() ? cell : i;
                };
                const auto beside = [&](size_t side) { return double(without[other(side)].x); };
                const double t = double(without[i].x), root = std::sqrt(t);
                double gap = 0, scatter = 0;
                for (size_t side = 0; side < 4; ++side)
                    gap += ((t + beside(side)) / 2 - std::sqrt(t * beside(side))) / 4;
                for (const size_t side : {0, 2})
                    if (other(side) != i && other(side + 1) != i)
                        scatter += std::pow((std::sqrt(beside(side)) + std::sqrt(beside(side + 1))) / 2 - root, 2);
                const double expected = t + double(shares.gap) * gap - double(shares.scatter) * scatter;
                if (near[i] == 0 || near[other(0)] == 0 || near[other(1)] == 0 || near[other(2)] == 0 ||
                    near[other(3)] == 0)
                    continue;  // the rest is not told
                largest = std::max(largest, std::abs(double(with[i].x) - near[i] * glm::clamp(expected, 0.0, 1.0)));
            }
            CHECK(largest < 1e-5);  // roots of floats, and about ten roundings of numbers up to 4
        }
}

// As seen by samples, before a polygon and behind it alike: whether hair is told apart does not depend on it.
TEST_CASE("hair next to a point behind what polygons show hides the sky as ever, one fiber behind another") {
    std::vector<Cone> behind;
    for (const float far : {1.0f, 1.5f, 2.0f})
        behind.push_back({far * Vec3(0.05f, -1, 1), far * Vec3(0, 1, 1), far * 0.05f, far * 0.05f});
    for (const ProjectionDetail detail : kDetails) {
        CAPTURE(int(detail));
        const ProjectedHair hair = projected(strands_of(behind), gray_fiber(), detail, without_gap());
        Viewpoint from{Vec3(0), random_frame(15), Dome::sphere};
        const std::vector<Rgb> open = seen(hair, from);
        const std::vector<float> sight(open.size(), 0.4f * 0.4f);
        from.sight = sight;
        CHECK(mean_difference(seen(hair, from), open) < 1e-6);
    }
}

TEST_CASE("hair behind what polygons show is not in sight, thin or wide, and hides the sky as ever") {
    for (const ProjectionDetail detail : kDetails)
        for (const float radius : {0.002f, 0.2f}) {
            CAPTURE(int(detail));
            CAPTURE(radius);
            const StrandSet strands = strands_of({{{1, -0.6f, 0.3f}, {1, 0.7f, 0.4f}, radius, radius},
                                                  {{-1, 0.02f, 1}, {1, 0.03f, 1.1f}, radius, radius}});
            const ProjectedHair hair = projected(strands, gray_fiber(), detail, without_gap());
            Viewpoint from{Vec3(0), random_frame(12), Dome::sphere};
            const std::vector<Rgb> open = seen(hair, from);
            CHECK(mean_of(open) < 0.9995);
            for (const float polygon : {0.4f, 3.0f}) {  // before the hair, and behind it
                CAPTURE(polygon);
                const std::vector<float> sight(open.size(), polygon * polygon);
                from.sight = sight;
                ProjectionScratch scratch;
                CellLight light;
                project(hair.projection, hair.segments(), from, {}, Isa::automatic, scratch);
                find_light(hair.projection, from, Isa::automatic, scratch, light);
                std::vector<Rgb> before;
                for (uint32_t cell = 0; cell < light.cells; ++cell)
                    before.push_back(light.transmittance_in_sight(cell));
                CHECK(mean_difference(cells_of(light), open) < 1e-6);
                CHECK(mean_difference(before, polygon < 1 ? std::vector<Rgb>(open.size(), Rgb(1)) : open) < 1e-6);
            }
        }
}

TEST_CASE("coloured hair whose colours are all gray is projected as gray hair is") {
    const StrandSet strands = random_hair(500, 0.5f, 0.005f, 8);
    const Viewpoint from{Vec3(0.2f), random_frame(9), Dome::sphere};
    const float sigma = 0.25f;  // a whole step: 0.2 of 1, as 25.6 / 128, is none; the nearest is 26 / 128
    const float step = 26 / 128.0f, nearest = step / (1 - step);
    REQUIRE(std::abs(nearest - sigma) < 0.01f);
    for (const ProjectionDetail detail : kDetails) {
        const ProjectedHair hair =
            projected(strands, colored(std::vector<Rgb>(strands.strands(), Rgb(sigma))), detail, without_gap());
        CHECK(hair.projection.opacity.gray);
        Attenuation gray{{make_attenuation_table(fiber_with(Rgb(nearest)))}, {}, {}, {}};
        // Tables of 128 and 256 rows, linear between them.
        CHECK(mean_difference(seen(hair, from), seen(projected(strands, gray, detail, without_gap()), from)) < 1e-3);
    }
}

TEST_CASE("three channels of hair that is nearly gray say what the one of gray hair does") {
    const StrandSet strands = random_hair(500, 0.5f, 0.005f, 10);
    const Viewpoint from{Vec3(0.2f), random_frame(11), Dome::sphere};
    for (const ProjectionDetail detail : kDetails) {
        const std::vector<Rgb> gray = seen(projected(strands, even_fiber(Rgb(1)), detail, without_gap()), from);
        const std::vector<Rgb> color =
            seen(projected(strands, even_fiber({1, 1.0001f, 1}), detail, without_gap()), from);
        double worst = 0;
        for (size_t i = 0; i < gray.size(); ++i) worst = std::max(worst, std::abs(double(gray[i].x - color[i].x)));
        CHECK(worst < 1e-5);  // the same sums in another order
    }
}

// By lots that are padded to sixteens: neither padding nor what another point left in the scratch arrays counts.
TEST_CASE("layers of which every segment is kept are all segments, however many there are") {
    ProjectionScratch scratch;
    CellLight light;
    for (const int count : {1, 15, 17, 40, 1100}) {
        CAPTURE(count);
        const StrandSet strands = random_hair(count, 0.3f, 0.003f, 9);
        Options options = without_gap();
        options.projection.layer = 1e9f;
        const ProjectedHair layers = projected(strands, gray_fiber(), ProjectionDetail::layers, options);
        const ProjectedHair all = projected(strands, gray_fiber(), ProjectionDetail::all, options);
        for (const Vec3& place : {Vec3(0.2f, 4, -1), Vec3(5, 0.1f, 2)}) {
            const Viewpoint from{place, kUpright, Dome::sphere, {}};
            project(layers.projection, layers.segments(), from, {}, Isa::automatic, scratch);
            find_light(layers.projection, from, Isa::automatic, scratch, light);
            // Sums in another order.
            CHECK(mean_difference(cells_of(light), seen(all, from)) < 1e-6);
        }
    }
}

// A first point leaves the rows of other hair, some of it near the second: were padding not cleared, it would be drawn.
TEST_CASE("what another point left in the scratch arrays changes no bit") {
    std::vector<Cone> others;
    for (uint64_t i = 0; i < 512; ++i) {
        const Vec3 way = sample_uniform_sphere({random(hash(14, i), 0), random(hash(14, i), 1)});
        others.push_back({0.5f * way, 2.2f * way + Vec3(0.1f), 0.003f, 0.003f});
    }
    Options options = without_gap();
    options.projection.layer = 1e9f;
    const Viewpoint elsewhere{Vec3(0.1f, 4, -1), kUpright, Dome::sphere, {}},
        from{Vec3(0), random_frame(15), Dome::sphere};
    const Attenuation fiber = even_fiber(Rgb(0.5f));  // gray: sums have more copies
    for (const ProjectionDetail detail : {ProjectionDetail::all, ProjectionDetail::layers, ProjectionDetail::tree})
        for (const int count : {497, 498, 499, 501, 503})
            for (const Isa isa : supported_isas()) {
                CAPTURE(int(detail));
                CAPTURE(count);
                CAPTURE(isa_name(isa));
                const ProjectedHair before = projected(strands_of(others), fiber, detail, options);
                const ProjectedHair hair = projected(random_hair(count, 2, 0.003f, 16), fiber, detail, options);
                ProjectionScratch scratch;
                CellLight light;
                project(before.projection, before.segments(), elsewhere, {}, isa, scratch);
                project(hair.projection, hair.segments(), from, {}, isa, scratch);
                find_light(hair.projection, from, isa, scratch, light);
                REQUIRE(cells_of(light) == seen_with(isa, hair, from, {}));
            }
}
