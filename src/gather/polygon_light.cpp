// SPDX-License-Identifier: MIT
#include "gather/polygon_light.h"

namespace tress {
namespace {

/// Geometric, on the side that a ray comes from.
Vec3 normal_towards(const TriangleMesh& mesh, uint32_t triangle, const Vec3& direction) {
    const std::array<Vec3, 3> corner = mesh.triangle(triangle);
    const DVec3 a(corner[0]);
    const Vec3 normal(normalize(cross(DVec3(corner[1]) - a, DVec3(corner[2]) - a)));
    return dot(normal, direction) > 0 ? -normal : normal;
}

}  // namespace

Rgb polygon_radiance(const Scene& scene, const IrradianceMap& map, uint32_t triangle, const Vec3& at,
                     const Vec3& direction) {
    const Rgb& albedo = scene.albedo[scene.mesh.surface[triangle]];
    if (!(max_component(albedo) > 0)) return Rgb(0);
    return albedo * kInvPi * irradiance(map, at, normal_towards(scene.mesh, triangle, direction));
}

void PolygonLight::operator()(const Scene& scene, const PreparedScene& prepared, const Options& options,
                              const GatherRays& rays, std::span<Rgb> radiance) {
    lit_rays_.clear();
    point_.clear();
    unshadowed_.clear();
    for (size_t ray = 0; ray < rays.rays.size(); ++ray) {
        if (rays.polygon[ray] == kNone) continue;
        const Vec3 direction = rays.rays.direction(ray), at = rays.rays.origin(ray) + rays.t[ray] * direction;
        const Rgb light =
            rays.weight[ray] * polygon_radiance(scene, prepared.photons.irradiance, rays.polygon[ray], at, direction);
        if (!(max_component(light) > 0)) continue;
        lit_rays_.add_from(rays.rays, ray);
        lit_rays_.set_far(point_.size(), rays.t[ray]);
        point_.push_back(rays.point[ray]);
        unshadowed_.push_back(light);
    }
    visibility_.resize(point_.size());
    through_hair(prepared, lit_rays_, options, visibility_);
    for (size_t i = 0; i < point_.size(); ++i) radiance[point_[i]] += unshadowed_[i] * visibility_[i];
}

}  // namespace tress
