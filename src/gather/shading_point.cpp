// SPDX-License-Identifier: MIT
#include "gather/shading_point.h"

#include "core/sampling.h"

namespace tress {
namespace {

/// How far a ray's origin is lifted off a polygon, in ulp of its largest coordinate: the rounding of the point itself
/// and of the triangle test's sheared corners stay below this.
constexpr float kLiftUlps = 32;

Vec3 lifted(const Vec3& p, const Vec3& normal) {
    const float ulp = max_component(abs(p)) * std::numeric_limits<float>::epsilon();
    return p + normal * (kLiftUlps * ulp);
}

Vec3 shading_normal(const TriangleMesh& mesh, const Hit& hit, const Vec3& geometric) {
    if (mesh.normal.empty()) return geometric;
    const uint32_t* c = &mesh.corner[3 * size_t(hit.id)];
    const float u = hit.u, v = hit.h;
    const Vec3 n = (1 - u - v) * mesh.normal[c[0]] + u * mesh.normal[c[1]] + v * mesh.normal[c[2]];
    const float length = glm::length(n);
    return length > 0.5f ? n / length : geometric;  // zero normals say flat
}

}  // namespace

ShadingPoint fiber_point(const Scene& scene, const PreparedScene& prepared, const Vec3& direction, const Hit& hit) {
    const SegmentView& segments = prepared.segments;
    const Vec3 start = segments.start(hit.id), axis = segments.end(hit.id) - start;
    const float radius = glm::mix(segments.start_radius(hit.id), segments.end_radius(hit.id), hit.u);
    const Vec3 tangent = normalize(axis);
    const Vec3 across = cross(direction, tangent);
    const float width = glm::length(across);

    ShadingPoint point;
    point.position = start + hit.u * axis;
    if (width > 0) point.position += across * (hit.h * radius / width);
    point.frame = fiber_frame(tangent, -direction);
    point.wo = point.frame.to_local(-direction);
    point.excluded.segments = touching(segments, hit.id);
    point.fiber = fiber_of(scene, hit.id);
    point.h = glm::clamp(hit.h, -1.0f, 1.0f);
    point.color =
        scene.sigma_a.empty() ? scene.fibers[point.fiber].parameters.sigma_a : scene.sigma_a[segments.point[hit.id]];
    point.depth = hit.t;
    return point;
}

ShadingPoint polygon_point(const Scene& scene, const Vec3& direction, const Hit& hit) {
    const auto [a, b, c] = scene.mesh.triangle(hit.id);
    Vec3 geometric = normalize(cross(b - a, c - a));
    Vec3 normal = shading_normal(scene.mesh, hit, geometric);
    if (dot(geometric, direction) > 0) geometric = -geometric;
    if (dot(normal, geometric) < 0) normal = -normal;

    ShadingPoint point;
    point.position = lifted((1 - hit.u - hit.h) * a + hit.u * b + hit.h * c, geometric);
    point.frame = frame_about(normal);
    point.wo = point.frame.to_local(-direction);
    point.geometric_normal = geometric;
    point.excluded.triangle = hit.id;
    point.color = scene.albedo[scene.mesh.surface[hit.id]];
    point.depth = hit.t;
    return point;
}

Scattering scatter(const Scene& scene, const ShadingPoint& point, const Vec3& wi) {
    const Vec3 local = point.frame.to_local(wi);
    if (point.fiber == kPolygon) {
        const float pdf = pdf_cosine_hemisphere(local.z);
        if (dot(wi, point.geometric_normal) <= 0) return {Rgb(0), pdf};
        return {point.color * pdf, pdf};  // albedo / pi cos theta
    }
    const FiberSample f = evaluate_with_pdf(scene.fibers[point.fiber], point.color, point.wo, local, point.h);
    return {f.value.forward + f.value.reflected, f.pdf};
}

Vec3 sample_scattering(const Scene& scene, const ShadingPoint& point, const glm::vec4& u) {
    if (point.fiber == kPolygon) return point.frame.to_world(sample_cosine_hemisphere({u.x, u.y}));
    return point.frame.to_world(sample(scene.fibers[point.fiber], point.color, point.wo, point.h, u).wi);
}

Rgb layer_albedo(const PreparedScene& prepared, const ShadingPoint& point) {
    if (point.fiber == kPolygon) return point.color;
    if (prepared.attenuation.table.empty() && prepared.attenuation.varying.empty()) return Rgb(0);
    return exp(-prepared.attenuation.depth(point.excluded.segments.first, 0));
}

}  // namespace tress
