// SPDX-License-Identifier: MIT
// The mesh tree: no cracks, both sides, the right distance, every instruction set.
#include <doctest/doctest.h>

#include <algorithm>

#include "accel/build.h"
#include "tools/check/support/tree_scenes.h"

using namespace tress;
using namespace tress::scenes;

namespace {

/// A closed ball of rows x 2 rows quads, each cut in two.
TriangleMesh ball(int rows, const Vec3& center = Vec3(0)) {
    TriangleMesh mesh;
    const int columns = 2 * rows;
    for (int i = 0; i <= rows; ++i) {
        for (int j = 0; j < columns; ++j) {
            const float theta = kPi * float(i) / float(rows), phi = 2 * kPi * float(j) / float(columns);
            const bool pole = i == 0 || i == rows;
            mesh.add_vertex(center + Vec3(pole ? 0 : std::sin(theta) * std::cos(phi),
                                          pole ? 0 : std::sin(theta) * std::sin(phi),
                                          i == 0 ? 1 : (i == rows ? -1 : std::cos(theta))));
        }
    }
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < columns; ++j) {
            const uint32_t a = uint32_t(i * columns + j), b = uint32_t(i * columns + (j + 1) % columns);
            const uint32_t c = a + uint32_t(columns), d = b + uint32_t(columns);
            for (const uint32_t corner : {a, c, d, a, d, b}) mesh.corner.push_back(corner);
        }
    }
    return mesh;
}

std::vector<uint8_t> occluded(const KdTree& tree, const RayBatch& rays, Isa isa = Isa::automatic) {
    std::vector<uint8_t> out(rays.size());
    occluded_triangle(tree, rays, out, isa);
    return out;
}

/// Distance by Cramer's rule in double; infinity where the ray clearly passes the triangle.
double distance_to(const std::array<Vec3, 3>& triangle, const DVec3& o, const DVec3& d) {
    const DVec3 a(triangle[0]), e1 = DVec3(triangle[1]) - a, e2 = DVec3(triangle[2]) - a;
    const double det = dot(cross(d, e2), e1);
    if (det == 0) return kInfinity;
    const double u = dot(cross(d, e2), o - a) / det, v = dot(cross(o - a, e1), d) / det;
    return std::min({u, v, 1 - u - v}) >= 0 ? dot(cross(o - a, e1), e2) / det : std::numeric_limits<double>::infinity();
}

}  // namespace

TEST_CASE("rays through shared edges and corners of a closed mesh always hit it") {
    const TriangleMesh mesh = ball(24);
    for (const float cost : {1.0f, 20.0f}) {
        AccelOptions options;
        options.traversal_cost = cost;
        const KdTree tree = build_triangle_tree(mesh, options);
        Rays rays;
        Dice dice(31);
        for (size_t t = 0; t < mesh.triangles(); ++t) {
            const auto triangle = mesh.triangle(t);
            for (int k = 0; k < 3; ++k) {
                const Vec3 o = 0.3f * dice.in_cube();
                rays.add(o, triangle[k] - o);
                for (const float s : {0.25f, 0.5f, 0.75f}) {
                    const Vec3 on_edge = triangle[k] + s * (triangle[(k + 1) % 3] - triangle[k]);
                    rays.add(o, on_edge - o);
                    rays.add(Vec3(0), on_edge);
                    rays.add(on_edge + 4.0f * (on_edge - o), o - on_edge);
                }
                Vec3 along(0);
                along[k] = 1;
                rays.add(Vec3(0.5f * triangle[0].x, 0, 0), along);  // in the planes of columns
            }
        }
        const Nearest found = nearest_on_mesh(tree, rays.batch());
        const std::vector<uint8_t> any = occluded(tree, rays.batch());
        size_t lost = 0;
        for (size_t i = 0; i < rays.size(); ++i) lost += found.id[i] == kNone || !any[i];
        CHECK(lost == 0);
    }
}

TEST_CASE("the nearest triangle is at the distance that double precision finds") {
    const TriangleMesh mesh = ball(12, Vec3(100, -50, 20));
    const KdTree tree = build_triangle_tree(mesh, AccelOptions{});
    const Rays rays = mixed_rays(4000, Vec3(100, -50, 20), 32);
    const Nearest found = nearest_on_mesh(tree, rays.batch());
    const std::vector<uint8_t> any = occluded(tree, rays.batch());
    size_t hits = 0, differ = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        const DVec3 o(rays.ox[i], rays.oy[i], rays.oz[i]), d(rays.dx[i], rays.dy[i], rays.dz[i]);
        double nearest_t = kInfinity;
        for (size_t t = 0; t < mesh.triangles(); ++t) {
            const double distance = distance_to(mesh.triangle(t), o, d);
            if (distance >= rays.t_near[i] && distance < rays.t_far[i]) nearest_t = std::min(nearest_t, distance);
        }
        CHECK((found.id[i] != kNone) == (any[i] != 0));
        hits += found.id[i] != kNone;
        // Single precision may take an edge, or an end of the ray, for the other side: a few 1e-7 of the ball.
        if ((found.id[i] != kNone) != (nearest_t < kInfinity))
            ++differ;
        else if (found.id[i] != kNone && std::abs(found.t[i] - nearest_t) * length(d) > 2e-5)
            ++differ;
    }
    CHECK(hits > 500);
    CHECK(differ <= 2);
}

TEST_CASE(
    "both sides are hit, barycentric coordinates give back the point, and nothing is flat enough to hit edge-on") {
    TriangleMesh mesh;
    mesh.add_vertex(Vec3(0, 0, 0));
    mesh.add_vertex(Vec3(1, 0, 0));
    mesh.add_vertex(Vec3(0, 1, 0));
    mesh.add_vertex(Vec3(0.5f, 0, 0));
    mesh.corner = {0, 1, 2, 0, 3, 1, 0, 0, 0};  // the second and third have no area
    const KdTree tree = build_triangle_tree(mesh, AccelOptions{});
    Rays rays;
    rays.add(Vec3(0.25f, 0.5f, 1), Vec3(0, 0, -1));
    rays.add(Vec3(0.25f, 0.5f, -1), Vec3(0, 0, 2));
    rays.add(Vec3(-1, 0.5f, 0), Vec3(1, 0, 0));
    rays.add(Vec3(0.75f, 0.5f, 1), Vec3(0, 0, -1));
    const Nearest found = nearest_on_mesh(tree, rays.batch());
    CHECK(found.id == std::vector<uint32_t>{0, 0, kNone, kNone});
    CHECK(found.t[0] == 1);
    CHECK(found.t[1] == 0.5f);
    for (const int i : {0, 1}) {
        CHECK(found.u[size_t(i)] == doctest::Approx(0.25));
        CHECK(found.h[size_t(i)] == doctest::Approx(0.5));
    }
}

TEST_CASE("every instruction set gives the same bits on triangles") {
    const TriangleMesh mesh = ball(16);
    const KdTree tree = build_triangle_tree(mesh, AccelOptions{});
    const Rays rays = mixed_rays(5000, Vec3(0), 33);
    const Nearest found = nearest_on_mesh(tree, rays.batch(), Isa::scalar);
    const std::vector<uint8_t> any = occluded(tree, rays.batch(), Isa::scalar);
    for (const Isa isa : supported_isas()) {
        CAPTURE(int(isa));
        CHECK(nearest_on_mesh(tree, rays.batch(), isa) == found);
        CHECK(occluded(tree, rays.batch(), isa) == any);
    }
}

TEST_CASE("an empty mesh is hit nowhere") {
    const KdTree tree = build_triangle_tree(TriangleMesh{}, AccelOptions{});
    const Rays rays = mixed_rays(10, Vec3(0), 34);
    for (const uint32_t id : nearest_on_mesh(tree, rays.batch()).id) CHECK(id == kNone);
    for (const uint8_t any : occluded(tree, rays.batch())) CHECK(any == 0);
}
