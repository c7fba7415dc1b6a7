// SPDX-License-Identifier: MIT
// A point that the eye sees, on a fiber or on a polygon, with all that shading it needs.
#pragma once

#include "core/fiber.h"
#include "core/frame.h"
#include "gather/prepared_scene.h"
#include "gather/ray_buffer.h"

namespace tress {

inline constexpr uint32_t kPolygon = 0xffffffffu;

struct ShadingPoint {
    Vec3 position;
    Frame frame;            // fiber: x along the tangent; polygon: z along the shading normal, on the eye's side
    Vec3 wo;                // to the eye, in the frame
    Vec3 geometric_normal;  // polygon: of the triangle, on the eye's side
    Vec3 on_surface{0};     // polygon: in its plane, where `position` is lifted off it so that rays may start there
    Excluded excluded;      // what rays from here must not meet
    uint32_t fiber = kPolygon;
    uint32_t segment = kNone;            // fiber: the one hit
    float h = 0;                         // fiber: offset of the hit, see fiber.h
    Rgb color{0};                        // fiber: sigma_a; polygon: albedo
    FiberLobes lobes = FiberLobes::all;  // fiber: what of f scatters here
    float depth = 0;                     // along the camera ray
};

/// A nearest hit, as queries return it (NearestHits in accel/queries.h).
struct Hit {
    float t;
    uint32_t id;
    float u, h;  // of a triangle h is the barycentric coordinate v
};

ShadingPoint fiber_point(const Scene& scene, const PreparedScene& prepared, const Vec3& direction, const Hit& hit);
ShadingPoint polygon_point(const Scene& scene, const Vec3& direction, const Hit& hit);

/// f |cos theta_i| towards a direction in its two parts, and the density with which sample_scattering draws it.
struct Scattering {
    Rgb forward{0};    // f_F |cos theta_i|: a fiber's TT lobe
    Rgb reflected{0};  // f_R |cos theta_i|, and all that a polygon does
    float pdf = 0;     // 1 / steradian

    Rgb value() const { return forward + reflected; }
};

/// `wi` is a unit vector (world).
Scattering scatter(const Scene& scene, const ShadingPoint& point, const Vec3& wi);

/// Unit direction (world) with density near proportional to f |cos theta_i|, and what scatters from there.
struct ScatteredDirection {
    Vec3 direction;
    Scattering scattering;
};
/// `u` is uniform in [0, 1)^4.
ScatteredDirection draw_scattering(const Scene& scene, const ShadingPoint& point, const glm::vec4& u);
/// As many as `drawn`, for less than one by one. `u` has as many rows.
void draw_scattering(const Scene& scene, const ShadingPoint& point, std::span<const glm::vec4> u,
                     std::span<ScatteredDirection> drawn);
/// The direction alone.
inline Vec3 sample_scattering(const Scene& scene, const ShadingPoint& point, const glm::vec4& u) {
    return draw_scattering(scene, point, u).direction;
}

/// For the albedo layer: of a polygon its own, of a fiber the share that goes straight through it at normal incidence.
Rgb layer_albedo(const Scene& scene, const PreparedScene& prepared, const ShadingPoint& point);

}  // namespace tress
