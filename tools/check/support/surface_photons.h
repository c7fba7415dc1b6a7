// SPDX-License-Identifier: MIT
// Meshes, and photons spread over them as known light would spread them.
#pragma once

#include <algorithm>

#include "core/mesh.h"
#include "core/rng.h"
#include "core/sampling.h"
#include "gather/photons/photon_list.h"

namespace tress::test {

inline void add_quad(TriangleMesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const uint32_t first = uint32_t(mesh.vertices());
    for (const Vec3& p : {a, b, c, d}) mesh.add_vertex(p);
    for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.corner.push_back(first + i);
}

/// Five sides of the unit cube, facing inwards; open towards +z.
inline TriangleMesh open_box() {
    TriangleMesh mesh;
    add_quad(mesh, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    add_quad(mesh, {0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1});
    add_quad(mesh, {1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0});
    add_quad(mesh, {0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0});
    add_quad(mesh, {0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1});
    return mesh;
}

/// A square of width 1 in the plane z = 0, facing +z.
inline TriangleMesh unit_square() {
    TriangleMesh mesh;
    add_quad(mesh, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    return mesh;
}

/// `n` unit squares side by side, each turned by `angle` (radians) against the one before: a faceted arch.
inline TriangleMesh arch(int n, float angle) {
    TriangleMesh mesh;
    Vec3 at(0);
    for (int i = 0; i < n; ++i) {
        const float turn = angle * float(i);
        const Vec3 next = at + Vec3(std::cos(turn), 0, std::sin(turn));
        add_quad(mesh, at, next, next + Vec3(0, 1, 0), at + Vec3(0, 1, 0));
        at = next;
    }
    return mesh;
}

/// Unit sphere of 2 n x n quads.
inline TriangleMesh sphere(int n) {
    const auto at = [n](int i, int j) {
        const float theta = kPi * float(j) / float(n), phi = kPi * float(i) / float(n);
        return Vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    };
    TriangleMesh mesh;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < 2 * n; ++i) add_quad(mesh, at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
    return mesh;
}

struct SurfaceSample {
    Vec3 position, normal;
};

/// Points spread evenly over the outsides of a mesh.
class SurfaceSampler {
public:
    explicit SurfaceSampler(const TriangleMesh& mesh) : mesh_(mesh) {
        double sum = 0;
        for (size_t t = 0; t < mesh.triangles(); ++t) {
            const auto c = mesh.triangle(t);
            sum += 0.5 * double(glm::length(cross(c[1] - c[0], c[2] - c[0])));
            sums_.push_back(sum);
        }
    }
    double area() const { return sums_.back(); }

    SurfaceSample sample(uint64_t key, uint64_t i) const {
        const float at = random(key, 3 * i), u = random(key, 3 * i + 1), v = random(key, 3 * i + 2);
        const auto above = std::upper_bound(sums_.begin(), sums_.end() - 1, double(at) * area());
        const auto c = mesh_.triangle(size_t(above - sums_.begin()));
        const Vec2 b = sample_triangle({u, v});
        return {c[0] + b.x * (c[1] - c[0]) + b.y * (c[2] - c[0]), normalize(cross(c[1] - c[0], c[2] - c[0]))};
    }

private:
    const TriangleMesh& mesh_;
    std::vector<double> sums_;  // of areas, up to and with each triangle
};

/// `n` photons of `power` together.
inline PhotonList uniform_photons(const TriangleMesh& mesh, size_t n, double power, PathType type = PathType::type1) {
    const SurfaceSampler surface(mesh);
    PhotonList list;
    for (size_t i = 0; i < n; ++i) {
        const SurfaceSample at = surface.sample(5, i);
        add(list, {at.position, -at.normal, Rgb(float(power / double(n))), type}, at.normal);
    }
    return list;
}

}  // namespace tress::test
