// SPDX-License-Identifier: MIT
#include "core/mesh_points.h"

#include "core/rng.h"
#include "core/sampler.h"
#include "core/sampling.h"

namespace tress {
namespace {

/// Twice the area, along the normal.
DVec3 area_vector(const std::array<Vec3, 3>& corner) {
    const DVec3 a(corner[0]);
    return cross(DVec3(corner[1]) - a, DVec3(corner[2]) - a);
}

}  // namespace

MeshPoints spread_points(const TriangleMesh& mesh, size_t n) {
    constexpr uint64_t kKey = hash(0, 0x73707265);
    double total = 0;
    for (size_t t = 0; t < mesh.triangles(); ++t) total += length(area_vector(mesh.triangle(t)));
    MeshPoints points;
    if (!(total > 0) || !std::isfinite(total)) return points;

    const double points_an_area = double(n) / total;
    double sum = 0;
    uint64_t made = 0;
    for (size_t t = 0; t < mesh.triangles(); ++t) {
        const std::array<Vec3, 3> corner = mesh.triangle(t);
        const DVec3 area = area_vector(corner);
        sum += length(area);
        const uint64_t end = uint64_t(sum * points_an_area + 0.5);
        const Vec3 normal(area / length(area));
        for (uint32_t i = 0; made < end; ++made, ++i) {
            const Vec2 b = sample_triangle(sobol_sample2(hash(kKey, t), i, 0));
            points.position.push_back(corner[0] + b.x * (corner[1] - corner[0]) + b.y * (corner[2] - corner[0]));
            points.normal.push_back(normal);
        }
    }
    return points;
}

}  // namespace tress
