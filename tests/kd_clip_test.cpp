// SPDX-License-Identifier: MIT
// Split clipping: where leaves hold a primitive, and the boxes of cut parts.
#include <doctest/doctest.h>

#include <algorithm>

#include "accel/segment_primitives.h"
#include "accel/triangle_primitives.h"
#include "tools/check/support/kd_sets.h"

namespace tress {
using namespace scenes;
namespace {

bool holds(const std::vector<uint32_t>& ids, uint32_t id) { return std::binary_search(ids.begin(), ids.end(), id); }

/// Axis of a segment in the coordinates of a tree, rounded as the tree does it.
struct Axis2 {
    DVec3 start, end;
};
Axis2 axis_of(const SegmentView& view, size_t id, const DVec3& origin) {
    return {DVec3(Vec3(DVec3(view.start(id)) - origin)), DVec3(Vec3(DVec3(view.end(id)) - origin))};
}

/// Whether part of the axis lies in the cell grown by `grow`.
bool passes(const Axis2& axis, const Bounds& cell, double grow) {
    double t0 = 0, t1 = 1;
    for (int k = 0; k < 3; ++k) {
        const double a = axis.start[k], d = axis.end[k] - a, lo = cell.lo[k] - grow, hi = cell.hi[k] + grow;
        if (d == 0) {
            if (a < lo || a > hi) return false;
            continue;
        }
        t0 = std::max(t0, std::min((lo - a) / d, (hi - a) / d));
        t1 = std::min(t1, std::max((lo - a) / d, (hi - a) / d));
    }
    return t0 <= t1;
}

/// Points within the radius of segment `id`, most of them on its rim, that are not in a leaf that holds it.
int lost_points(const KdTree& tree, const SegmentView& view, uint32_t id, int points) {
    const Axis2 axis = axis_of(view, id, tree.origin);
    Stream stream{hash(7, id)};
    int lost = 0;
    for (int i = 0; i < points; ++i) {
        const double u = i < 2 ? double(i) : double(stream.unit());
        const double r = view.start_radius(id) + u * (double(view.end_radius(id)) - view.start_radius(id));
        const DVec3 direction = normalize(DVec3(stream.vector(-1, 1)) + 1e-9);
        const double inside = i % 4 == 0 ? double(stream.unit()) : 1.0;
        const Vec3 p(axis.start + u * (axis.end - axis.start) + inside * r * direction);
        lost += !holds(leaf_ids(tree, leaf_at(tree, p), segment_row::id), id);
    }
    return lost;
}

}  // namespace

TEST_CASE("every point within the radius of a segment lies in a leaf that holds the segment") {
    for (const SegmentSet& set : hard_sets(1000)) {
        for (const SplitMethod method :
             {SplitMethod::binned, SplitMethod::exact, SplitMethod::spatial_median, SplitMethod::object_median}) {
            for (const bool clip : {true, false}) {
                CAPTURE(set.name);
                CAPTURE(int(method));
                CAPTURE(clip);
                AccelOptions options = deep_options(method);
                options.clip = clip;
                const KdTree tree = build_segment_tree(set.view(), options);
                int lost = 0;
                for (uint32_t id = 0; id < set.point.size(); ++id) lost += lost_points(tree, set.view(), id, 20);
                CHECK(lost == 0);
            }
        }
    }
}

TEST_CASE("a leaf holds no segment whose axis stays farther than its padded radius from the cell") {
    for (const SegmentSet& set : hard_sets(600)) {
        CAPTURE(set.name);
        const SegmentView view = set.view();
        const KdTree tree = build_segment_tree(view, deep_options());
        // Boxes may be wider by the roundings of the largest coordinate, twice: of the radius, and of box to float.
        const double padding = 2 * kPadding * largest_coordinate(tree.bounds);
        size_t strangers = 0;
        for (const LeafCell& leaf : leaf_cells(tree))
            for (const uint32_t id : leaf_ids(tree, *leaf.leaf, segment_row::id)) {
                const double radius = std::max(view.start_radius(id), view.end_radius(id));
                strangers += !passes(axis_of(view, id, tree.origin), leaf.cell, radius + padding);
            }
        CHECK(strangers == 0);
    }
}

TEST_CASE("clipping holds fewer references than boxes alone") {
    const SegmentSet set = random_segments(2000, 1, 0.002f);
    AccelOptions options = deep_options();
    options.traversal_cost = 20;
    const size_t clipped = build_segment_tree(set.view(), options).leaves.values.size();
    options.clip = false;
    CHECK(clipped < build_segment_tree(set.view(), options).leaves.values.size());
}

TEST_CASE("a segment cut at a plane keeps the part within its radius of that side") {
    SegmentSet set;
    set.add({0, 0, 0}, {8, 4, 0}, 0.5f);
    const SegmentPrimitives segments(set.view(), DVec3(0));
    const double pad = kPadding * 8.5;
    const Reference whole = segments.reference(0);
    CHECK(whole.lo.x == doctest::Approx(-0.5 - pad).epsilon(1e-6));
    CHECK(whole.hi.y == doctest::Approx(4.5 + pad).epsilon(1e-6));

    SUBCASE("half") {  // the axis is kept up to x = 4.5, so y up to 2.25 and a radius
        Reference part = whole;
        part.hi.x = below(4);
        REQUIRE(segments.clip_below(part, 0, 4));
        CHECK(part.hi.x == below(4));
        CHECK(part.hi.y == doctest::Approx(2.75).epsilon(1e-4));
        part = whole;
        part.lo.x = 4;
        REQUIRE(segments.clip_above(part, 0, 4));  // from x = 3.5, y = 1.75, less a radius
        CHECK(part.lo.y == doctest::Approx(1.25).epsilon(1e-4));
        CHECK(part.hi.y == whole.hi.y);
    }
    SUBCASE("inside") {
        Reference part = whole;
        REQUIRE(segments.clip_below(part, 0, 100));
        CHECK(part.lo == whole.lo);
        CHECK(part.hi == whole.hi);
    }
    SUBCASE("outside") {
        Reference part = whole;
        CHECK_FALSE(segments.clip_above(part, 0, 9));
    }
    SUBCASE("touching") {
        Reference part = whole;
        part.lo.x = 8.5f;
        CHECK(segments.clip_above(part, 0, 8.5f));
        part = whole;
        part.lo.x = 8.5f + float(4 * pad);
        CHECK_FALSE(segments.clip_above(part, 0, part.lo.x));
    }
    SUBCASE("flat along the cut axis") {
        Reference part = whole;
        part.hi.z = below(0);
        REQUIRE(segments.clip_below(part, 2, 0));
        CHECK(part.lo == whole.lo);
        CHECK(part.hi.x == whole.hi.x);
        part = whole;
        CHECK_FALSE(segments.clip_above(part, 2, 0.6f));
    }
    SUBCASE("cut twice, past the corner that the axis does not meet") {
        Reference part = whole;
        part.lo.x = 6;
        REQUIRE(segments.clip_above(part, 0, 6));
        part.hi.y = below(1);
        CHECK_FALSE((part.lo.y <= part.hi.y && segments.clip_below(part, 1, 1)));
    }
}

TEST_CASE("a tapered segment is grown by the radius of the part that is kept") {
    SegmentSet set;
    set.add({0, 0, 0}, {10, 0, 0}, 1, 0);
    const SegmentPrimitives segments(set.view(), DVec3(0));
    Reference part = segments.reference(0);
    part.lo.x = 8;
    REQUIRE(segments.clip_above(part, 0, 8));
    CHECK(part.hi.y == doctest::Approx(0.3).epsilon(1e-3));  // the axis is kept from x = 7 on
}

TEST_CASE("padding covers the scene's roundings, but swells thin hair by an eighth at most where outliers are far") {
    SegmentSet set = random_segments(10, 1, 1e-3f);
    set.add({1e6f, 0, 0}, {1e6f, 1, 0}, 1e-3f);
    const SegmentPrimitives segments(set.view(), DVec3(0));
    const Reference box = segments.reference(0);
    const AxisSegment& s = segments[0];
    const float width = max(s.start, s.end).y - min(s.start, s.end).y;
    CHECK(box.hi.y - box.lo.y > width + 2e-3f);
    CHECK(box.hi.y - box.lo.y < width + 2e-3f * 1.13f);
}

namespace {

TriangleMesh random_triangles(size_t n, float size) {
    TriangleMesh mesh;
    Stream stream{11};
    for (size_t t = 0; t < n; ++t) {
        const Vec3 p = stream.vector(-1, 1);
        for (uint32_t k = 0; k < 3; ++k) {
            mesh.add_vertex(p + stream.vector(-size, size));
            mesh.corner.push_back(uint32_t(3 * t + k));
        }
    }
    return mesh;
}

/// Triangles of a lattice in the planes z = 0 and x = 1, and some without area.
TriangleMesh flat_triangles(int side) {
    TriangleMesh mesh;
    const auto add = [&mesh](const Vec3& a, const Vec3& b, const Vec3& c) {
        for (const Vec3& p : {a, b, c}) {
            mesh.corner.push_back(uint32_t(mesh.vertices()));
            mesh.add_vertex(p);
        }
    };
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const float x = float(i), y = float(j);
            add({x, y, 0}, {x + 1, y, 0}, {x, y + 1, 0});
            add({x + 1, y + 1, 0}, {x, y + 1, 0}, {x + 1, y, 0});
            add({1, x, y}, {1, x + 1, y}, {1, x, y + 1});
            if (j == 0) add({x, y, 0}, {x, y, 0}, {x, y, 0});
        }
    return mesh;
}

/// Whether the triangle is apart from the box along `axis`.
bool is_apart(const std::array<DVec3, 3>& corners, const DBounds& box, const DVec3& axis) {
    const DVec3 half = 0.5 * box.extent();
    const double reach = dot(half, abs(axis)) * (1 + 1e-12);
    double lo = std::numeric_limits<double>::infinity(), hi = -lo;
    for (const DVec3& p : corners) {
        lo = std::min(lo, dot(p - box.center(), axis));
        hi = std::max(hi, dot(p - box.center(), axis));
    }
    return lo > reach || hi < -reach;
}

/// Separating axes of triangle and box: three of the box, the normal, nine products of edges.
bool overlap(const std::array<DVec3, 3>& c, const DBounds& box) {
    if (is_apart(c, box, cross(c[1] - c[0], c[2] - c[0]))) return false;
    for (int k = 0; k < 3; ++k) {
        DVec3 unit(0);
        unit[k] = 1;
        if (is_apart(c, box, unit)) return false;
        for (size_t e = 0; e < 3; ++e)
            if (is_apart(c, box, cross(unit, c[(e + 1) % 3] - c[e]))) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("every point of a triangle lies in a leaf that holds it, and leaves hold no stranger") {
    for (const TriangleMesh& mesh : {random_triangles(1500, 0.2f), random_triangles(100, 3), flat_triangles(20)}) {
        for (const SplitMethod method : {SplitMethod::binned, SplitMethod::exact, SplitMethod::spatial_median}) {
            CAPTURE(mesh.triangles());
            CAPTURE(int(method));
            const KdTree tree = build_triangle_tree(mesh, deep_options(method));
            const auto corners = [&](size_t t) {
                std::array<DVec3, 3> c;
                for (size_t k = 0; k < 3; ++k) c[k] = DVec3(Vec3(DVec3(mesh.triangle(t)[k]) - tree.origin));
                return c;
            };
            int lost = 0;
            for (uint32_t t = 0; t < mesh.triangles(); ++t) {
                Stream stream{hash(5, t)};
                const std::array<DVec3, 3> c = corners(t);
                for (int i = 0; i < 20; ++i) {
                    const double u = i < 3 ? double(i == 1) : double(stream.unit());
                    const double v = i < 3 ? double(i == 2) : (1 - u) * double(stream.unit());
                    const Vec3 p(c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0]));
                    lost += !holds(leaf_ids(tree, leaf_at(tree, p), triangle_row::id), t);
                }
            }
            CHECK(lost == 0);
            int strangers = 0;
            const double padding = 2.5 * kPadding * largest_coordinate(tree.bounds);  // of clip, box and rounding
            for (const LeafCell& leaf : leaf_cells(tree)) {
                const DBounds grown{DVec3(leaf.cell.lo) - padding, DVec3(leaf.cell.hi) + padding};
                for (const uint32_t id : leaf_ids(tree, *leaf.leaf, triangle_row::id))
                    strangers += !overlap(corners(id), grown);
            }
            CHECK(strangers == 0);
        }
    }
}

TEST_CASE("a triangle cut at a plane keeps the box of its polygon") {
    TriangleMesh mesh;
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)}) mesh.add_vertex(p);
    mesh.corner = {0, 1, 2};
    const TrianglePrimitives triangles(mesh, DVec3(0));
    Reference part = triangles.reference(0);
    part.lo.x = 3;
    REQUIRE(triangles.clip_above(part, 0, 3));
    CHECK(part.hi.y == doctest::Approx(1).epsilon(1e-4));
    part.lo.y = 2;
    CHECK_FALSE((part.lo.y <= part.hi.y && triangles.clip_above(part, 1, 2)));
}

}  // namespace tress
