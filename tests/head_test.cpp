// SPDX-License-Identifier: MIT
#include "core/head.h"

#include <doctest/doctest.h>

#include <map>

#include "core/isosurface.h"

using namespace tress;

namespace {

/// How often each directed edge occurs.
std::map<std::pair<uint32_t, uint32_t>, int> edges(const TriangleMesh& mesh) {
    std::map<std::pair<uint32_t, uint32_t>, int> count;
    for (size_t t = 0; t < mesh.triangles(); ++t) {
        for (size_t k = 0; k < 3; ++k) ++count[{mesh.corner[3 * t + k], mesh.corner[3 * t + (k + 1) % 3]}];
    }
    return count;
}

bool is_closed(const TriangleMesh& mesh) {
    const auto count = edges(mesh);
    for (const auto& [edge, times] : count) {
        const auto reverse = count.find({edge.second, edge.first});
        if (times != 1 || reverse == count.end()) return false;
    }
    return !count.empty();
}

double signed_volume(const TriangleMesh& mesh) {
    double sum = 0;
    for (size_t t = 0; t < mesh.triangles(); ++t) {
        const auto c = mesh.triangle(t);
        sum += dot(DVec3(c[0]), cross(DVec3(c[1]), DVec3(c[2]))) / 6;
    }
    return sum;
}

}  // namespace

TEST_CASE("the surface net of a sphere is closed, of one piece without holes, and near the sphere") {
    const float radius = 5, cell = 0.5f;
    const auto sphere = [&](const Vec3& p) { return length(p) - radius; };
    const TriangleMesh mesh = isosurface(sample_grid(sphere, {Vec3(-6.1f), Vec3(6.2f)}, cell));
    CHECK(is_closed(mesh));
    // Euler: V - E + F = 2, with E = 3 F / 2.
    CHECK(2 * mesh.vertices() == mesh.triangles() + 4);
    // Linear crossings are off by at most h^2 / 8R, and the mean of points within a cell's diagonal by 3 h^2 / 8R.
    const float bound = cell * cell / (2 * radius);
    for (size_t v = 0; v < mesh.vertices(); ++v) REQUIRE(std::abs(length(mesh.vertex(v)) - radius) < bound);
    const double exact = 4.0 / 3 * double(kPi) * 125;
    CHECK(signed_volume(mesh) > 0);
    // All vertices within the bound of the surface, and chords of at most 2 cells below it by (2 h)^2 / 8R more.
    CHECK(std::abs(signed_volume(mesh) / exact - 1) < 3 * (bound + cell * cell / (2 * radius)) / radius);
}

TEST_CASE("a sampled field gives back a linear one and its gradient, also between nodes") {
    const Vec3 slope(1, -2, 0.5f);
    const ScalarGrid grid = sample_grid([&](const Vec3& p) { return dot(slope, p); }, {Vec3(-1), Vec3(1)}, 0.3f);
    for (const Vec3& p : {Vec3(0), Vec3(0.13f, -0.77f, 0.5f), Vec3(-1), Vec3(0.99f)}) {
        const GridValue at = interpolate(grid, p);
        CHECK(at.value == doctest::Approx(dot(slope, p)).epsilon(1e-5));
        CHECK(distance(at.gradient, slope) < 1e-4f);
    }
}

TEST_CASE("the head is closed and faces outward, of the size of a head on shoulders") {
    const TriangleMesh mesh = make_head();
    CHECK(mesh.triangles() > 20000);
    CHECK(mesh.triangles() < 60000);
    CHECK(is_closed(mesh));
    Bounds box;
    for (size_t v = 0; v < mesh.vertices(); ++v) box.add(mesh.vertex(v));
    CHECK(box.hi.y == doctest::Approx(11).epsilon(0.01));
    // More than the ellipsoid of the skull, less than the box about all.
    CHECK(signed_volume(mesh) > 2308);
    CHECK(signed_volume(mesh) < double(box.extent().x * box.extent().y * box.extent().z));
    // The chin is the lowest of the face: forward of the neck.
    float chin = 0;
    for (size_t v = 0; v < mesh.vertices(); ++v) {
        const Vec3 p = mesh.vertex(v);
        if (std::abs(p.x) < 0.5f && p.z > 5.5f && p.y > -13) chin = glm::min(chin, p.y);
    }
    CHECK(chin == doctest::Approx(-11).epsilon(0.05));
}

TEST_CASE("the head's vertices lie on its field, and its normals are unit, outward and those of its faces") {
    const TriangleMesh mesh = make_head();
    REQUIRE(mesh.normal.size() == mesh.vertices());
    for (size_t v = 0; v < mesh.vertices(); ++v) {
        REQUIRE(length(mesh.normal[v]) == doctest::Approx(1).epsilon(1e-5));
        // Newton steps end near the rounding of coordinates up to 32 but where the field bends sharply.
        REQUIRE(std::abs(head_distance(mesh.vertex(v))) < 5e-3f);
    }
    size_t against = 0;
    for (size_t t = 0; t < mesh.triangles(); ++t) {
        const auto c = mesh.triangle(t);
        const Vec3 face = cross(c[1] - c[0], c[2] - c[0]);
        const Vec3 mean =
            mesh.normal[mesh.corner[3 * t]] + mesh.normal[mesh.corner[3 * t + 1]] + mesh.normal[mesh.corner[3 * t + 2]];
        against += dot(face, mean) <= 0;
    }
    CHECK(against == 0);
}

TEST_CASE("the head is negative inside, positive outside, and the same left and right") {
    CHECK(head_distance({0, 3, 0}) < -5);
    CHECK(head_distance({0, -15, -3}) < 0);
    CHECK(head_distance({0, 3, 20}) > 5);
    CHECK(head_distance({20, 5, 0}) > 5);
    for (const Vec3& p : {Vec3(7, 0, 1), Vec3(3, -6, 8), Vec3(15, -20, -4)})
        CHECK(head_distance(p) == head_distance({-p.x, p.y, p.z}));
}
