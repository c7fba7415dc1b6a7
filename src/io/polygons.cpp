// SPDX-License-Identifier: MIT
#include "io/polygons.h"

#include "core/error.h"

namespace tress {
namespace {

bool has_direction(const Vec3& v) {
    const double length2 = dot(DVec3(v), DVec3(v));
    return std::isfinite(length2) && length2 > 0;
}

/// Area-weighted normals of the triangles about the vertices marked in `wanted`.
void replace_normals(TriangleMesh& mesh, const std::vector<bool>& wanted) {
    std::vector<DVec3> sum(mesh.vertices(), DVec3(0));
    for (size_t t = 0; t < mesh.triangles(); ++t) {
        const auto [a, b, c] = mesh.triangle(t);
        const DVec3 normal = cross(DVec3(b) - DVec3(a), DVec3(c) - DVec3(a));
        for (size_t k = 0; k < 3; ++k) sum[mesh.corner[3 * t + k]] += normal;
    }
    for (size_t v = 0; v < mesh.vertices(); ++v) {
        if (!wanted[v]) continue;
        const double length = glm::length(sum[v]);
        mesh.normal[v] = length > 0 ? Vec3(sum[v] / length) : Vec3(0, 0, 1);  // any: no area can show it
    }
}

}  // namespace

void add_polygon(TriangleMesh& mesh, std::span<const uint32_t> corners) {
    for (size_t k = 2; k < corners.size(); ++k)
        for (const uint32_t corner : {corners[0], corners[k - 1], corners[k]}) mesh.corner.push_back(corner);
}

void finish_mesh(const std::string& path, TriangleMesh& mesh) {
    if (mesh.triangles() == 0) throw InputError(path, "no faces");
    for (size_t v = 0; v < mesh.vertices(); ++v)
        if (!is_finite(mesh.vertex(v)))
            throw InputError(path,
                             "vertex " + std::to_string(v + 1) + " is not finite, expected numbers a float holds");
    if (mesh.normal.empty()) return;
    std::vector<bool> wanted(mesh.vertices());
    bool any = false;
    for (size_t v = 0; v < mesh.vertices(); ++v) {
        Vec3& n = mesh.normal[v];
        if (has_direction(n))
            n = Vec3(normalize(DVec3(n)));
        else
            any = wanted[v] = true;
    }
    if (any) replace_normals(mesh, wanted);
}

}  // namespace tress
