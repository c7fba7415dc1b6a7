// SPDX-License-Identifier: MIT
#include "gather/projection/moment_tree.h"

#include <tbb/global_control.h>

#include <cstring>

#include "tests/projection_support.h"

using namespace tress;
using namespace tress::test;

namespace {

double area_of(const SegmentView& hair) {
    double sum = 0;
    for (size_t i = 0; i < hair.size(); ++i)
        sum += double(glm::length(hair.end(i) - hair.start(i))) * double(hair.start_radius(i) + hair.end_radius(i));
    return sum;
}

double area_of(const MomentTree& tree) {
    double sum = 0;
    if (tree.blocks.empty()) return sum;
    const MomentBlock& root = tree.blocks[0];
    for (int o = 0; o < 8; ++o) sum += double(root.xx[o]) + double(root.yy[o]) + double(root.zz[o]);
    return sum;
}

Vec3 place(const MomentTree& tree, size_t leaf, uint16_t x, uint16_t y, uint16_t z) {
    return tree.leaf_low[leaf] + tree.leaf_size[leaf] / 65535 * Vec3(x, y, z);
}

double length_of_pieces(const MomentTree& tree) {
    double sum = 0;
    const MomentPieces& p = tree.pieces;
    for (size_t leaf = 0; leaf < tree.leaf_low.size(); ++leaf)
        for (size_t i = tree.leaf_first[leaf]; i < tree.leaf_first[leaf + 1]; ++i)
            sum += double(glm::distance(place(tree, leaf, p.ax[i], p.ay[i], p.az[i]),
                                        place(tree, leaf, p.bx[i], p.by[i], p.bz[i])));
    return sum;
}

MomentTree tree_of(const StrandSet& strands, int leaf_pieces = 4) {
    const SegmentList list = list_segments(strands);
    return make_moment_tree(view(strands, list), make_hair_opacity(gray_fiber()), {leaf_pieces, 0.01f});
}

bool same(const MomentTree& a, const MomentTree& b) {
    const MomentPieces &p = a.pieces, &q = b.pieces;
    return a.blocks.size() == b.blocks.size() && a.leaf_first == b.leaf_first && a.leaf_low == b.leaf_low &&
           a.leaf_size == b.leaf_size && p.segment == q.segment && p.ax == q.ax && p.ay == q.ay && p.az == q.az &&
           p.bx == q.bx && p.by == q.by && p.bz == q.bz && p.start_radius == q.start_radius &&
           p.end_radius == q.end_radius &&
           std::memcmp(a.blocks.data(), b.blocks.data(), a.blocks.size() * sizeof(MomentBlock)) == 0;
}

}  // namespace

TEST_CASE("no part of the hair is lost or counted twice by a tree") {
    const StrandSet strands = random_hair(2000, 0.5f, 0.01f, 7);
    const SegmentList list = list_segments(strands);
    const SegmentView hair = view(strands, list);
    double length = 0;
    for (size_t i = 0; i < hair.size(); ++i) length += double(glm::length(hair.end(i) - hair.start(i)));
    for (const int leaf : {1, 16, 1 << 20}) {
        CAPTURE(leaf);
        const MomentTree tree = tree_of(strands, leaf);
        CHECK(area_of(tree) == doctest::Approx(area_of(hair)).epsilon(1e-5));
        // Ends are rounded to 2^-17 of a cube, of which the shortest piece may be a part.
        CHECK(length_of_pieces(tree) == doctest::Approx(length).epsilon(1e-4));
    }
}

TEST_CASE("hair on the cutting planes, alike hair and a lone segment keep their area") {
    std::vector<Cone> planes, alike;
    for (int i = -8; i <= 8; ++i) {
        const float at = float(i) / 8;
        planes.push_back({{-1, at, 0}, {1, at, 0}, 0.01f, 0.01f});
        planes.push_back({{at, 0, -1}, {at, 0, 1}, 0.01f, 0.02f});
        planes.push_back({{0, -1, at}, {0, 1, at}, 0.01f, 0.01f});
    }
    for (int i = 0; i < 1000; ++i) alike.push_back({{0, 0, 0}, {0.3f, 0.2f, 0.1f}, 0.01f, 0.01f});
    for (const std::vector<Cone>& cones : {planes, alike, {alike.front()}}) {
        const StrandSet strands = strands_of(cones);
        const SegmentList list = list_segments(strands);
        CHECK(area_of(tree_of(strands)) == doctest::Approx(area_of(view(strands, list))).epsilon(1e-5));
    }
    CHECK(tree_of({}).blocks.empty());
}

TEST_CASE("a tree is the same for any number of threads") {
    const StrandSet strands = random_hair(3000, 0.5f, 0.01f, 8);
    const MomentTree many = tree_of(strands);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    CHECK(same(many, tree_of(strands)));
}

TEST_CASE("a tree whose every cube is opened shows what all segments show") {
    Options options = without_gap();
    options.projection.opening = 0.1f;
    const StrandSet strands = random_hair(1500, 0.5f, 0.0005f, 9);
    const Viewpoint from{Vec3(0.1f, 0, 0.2f), random_frame(10), Dome::sphere};
    const auto cells = [&](ProjectionDetail detail) {
        return seen(projected(strands, gray_fiber(), detail, options), from);
    };
    // Segments of a splat each lie in one cell, cut ones in those that they are seen in: of neighbouring cells one may
    // get what is the other's, half a cell's length of a fiber at most, and few cells are so near to a fiber's end.
    const std::vector<Rgb> tree = cells(ProjectionDetail::tree), all = cells(ProjectionDetail::all);
    CHECK(mean_difference(tree, all) < 0.01);
    CHECK(mean_of(tree) == doctest::Approx(mean_of(all)).epsilon(2e-3));
}

TEST_CASE("a tree at its defaults lets through, on the whole, what all segments do") {
    for (const float radius : {0.001f, 0.004f}) {
        CAPTURE(radius);
        const StrandSet strands = random_hair(4000, 0.5f, radius, 11);
        const Viewpoint from{Vec3(0.1f, 0, 0.2f), random_frame(12), Dome::sphere};
        const auto mean = [&](ProjectionDetail detail) {
            return mean_of(seen(projected(strands, gray_fiber(), detail, without_gap()), from));
        };
        CHECK(mean(ProjectionDetail::tree) == doctest::Approx(mean(ProjectionDetail::all)).epsilon(0.02));
    }
}
