// SPDX-License-Identifier: MIT
#include "gather/shading_point.h"

#include <array>

#include "core/sampling.h"

namespace tress {
namespace {

double largest_component(const DVec3& x) { return glm::max(glm::max(std::abs(x.x), std::abs(x.y)), std::abs(x.z)); }

/// How far a point of a triangle is lifted off it: by what rounding may sink it, its own and that of the corners as a
/// ray that starts here sees them.
double lift_of(const DVec3& p, const DVec3& a, const DVec3& b, const DVec3& c) {
    constexpr double epsilon = std::numeric_limits<float>::epsilon(), point_ulps = 32, corner_ulps = 8;
    const double of_corners = glm::max(glm::max(largest_component(a), largest_component(b)), largest_component(c));
    return epsilon * (point_ulps * largest_component(p) + corner_ulps * of_corners);
}

Vec3 shading_normal(const TriangleMesh& mesh, const Hit& hit, const Vec3& geometric) {
    if (mesh.normal.empty()) return geometric;
    const uint32_t* c = &mesh.corner[3 * size_t(hit.id)];
    const float u = hit.u, v = hit.h;
    const Vec3 n = (1 - u - v) * mesh.normal[c[0]] + u * mesh.normal[c[1]] + v * mesh.normal[c[2]];
    const float length = glm::length(n);
    return length > 0.5f ? n / length : geometric;  // zero normals say flat
}

/// albedo / pi cos theta, and nothing from behind the triangle.
Scattering scatter_by_polygon(const ShadingPoint& point, const Vec3& wi, float cos_theta) {
    const float pdf = pdf_cosine_hemisphere(cos_theta);
    if (dot(wi, point.geometric_normal) <= 0) return {Rgb(0), Rgb(0), pdf};
    return {Rgb(0), point.color * pdf, pdf};
}

Scattering of_fiber(const FiberSample& f) { return {f.value.forward, f.value.reflected, f.pdf}; }

}  // namespace

ShadingPoint fiber_point(const Scene& scene, const PreparedScene& prepared, const Vec3& direction, const Hit& hit) {
    const SegmentView& segments = prepared.segments;
    const Vec3 start = segments.start(hit.id), axis = segments.end(hit.id) - start;
    const float radius = glm::mix(segments.start_radius(hit.id), segments.end_radius(hit.id), hit.u);
    const Vec3 tangent(normalize(DVec3(axis)));  // in double: a square of 1e-20 is nothing in float
    const Vec3 across = cross(direction, tangent);
    const float width = glm::length(across);

    ShadingPoint point;
    point.position = start + hit.u * axis;
    if (width > 0) point.position += across * (hit.h * radius / width);
    point.frame = fiber_frame(tangent, -direction);
    point.wo = point.frame.to_local(-direction);
    point.excluded.segments = own_strand(segments, hit.id);
    point.segment = hit.id;
    point.fiber = fiber_of(scene, hit.id);
    point.h = glm::clamp(hit.h, -1.0f, 1.0f);
    point.color =
        scene.sigma_a.empty() ? scene.fibers[point.fiber].parameters.sigma_a : scene.sigma_a[segments.point[hit.id]];
    point.depth = hit.t;
    return point;
}

ShadingPoint polygon_point(const Scene& scene, const Vec3& direction, const Hit& hit) {
    const std::array<Vec3, 3> corner = scene.mesh.triangle(hit.id);
    const DVec3 a(corner[0]), b(corner[1]), c(corner[2]);
    DVec3 geometric = normalize(cross(b - a, c - a));
    Vec3 normal = shading_normal(scene.mesh, hit, Vec3(geometric));
    if (dot(geometric, DVec3(direction)) > 0) geometric = -geometric;
    if (dot(normal, Vec3(geometric)) < 0) normal = -normal;

    ShadingPoint point;
    const DVec3 p = a + double(hit.u) * (b - a) + double(hit.h) * (c - a);
    point.position = Vec3(p + lift_of(p, a, b, c) * geometric);
    point.on_surface = Vec3(p);
    point.frame = frame_about(normal);
    point.wo = point.frame.to_local(-direction);
    point.geometric_normal = Vec3(geometric);
    point.excluded.triangle = hit.id;
    point.color = scene.albedo[scene.mesh.surface[hit.id]];
    point.depth = hit.t;
    return point;
}

Scattering scatter(const Scene& scene, const ShadingPoint& point, const Vec3& wi) {
    const Vec3 local = point.frame.to_local(wi);
    if (point.fiber == kPolygon) return scatter_by_polygon(point, wi, local.z);
    return of_fiber(evaluate_with_pdf(scene.fibers[point.fiber], point.color, point.wo, local, point.h, point.lobes));
}

ScatteredDirection draw_scattering(const Scene& scene, const ShadingPoint& point, const glm::vec4& u) {
    ScatteredDirection drawn;
    draw_scattering(scene, point, {&u, 1}, {&drawn, 1});
    return drawn;
}

void draw_scattering(const Scene& scene, const ShadingPoint& point, std::span<const glm::vec4> u,
                     std::span<ScatteredDirection> drawn) {
    if (point.fiber == kPolygon) {
        for (size_t i = 0; i < drawn.size(); ++i) {
            const Vec3 local = sample_cosine_hemisphere({u[i].x, u[i].y});
            const Vec3 wi = point.frame.to_world(local);
            drawn[i] = {wi, scatter_by_polygon(point, wi, local.z)};
        }
        return;
    }
    std::array<FiberSample, 32> samples;
    for (size_t first = 0; first < drawn.size(); first += samples.size()) {
        const size_t count = std::min(samples.size(), drawn.size() - first);
        sample(scene.fibers[point.fiber], point.color, point.wo, point.h, u.subspan(first, count),
               std::span(samples).first(count), point.lobes);
        for (size_t i = 0; i < count; ++i)
            drawn[first + i] = {point.frame.to_world(samples[i].wi), of_fiber(samples[i])};
    }
}

Rgb layer_albedo(const Scene& scene, const PreparedScene& prepared, const ShadingPoint& point) {
    if (point.fiber == kPolygon) return point.color;
    const Attenuation& a = prepared.attenuation;
    const bool unlit = a.table.empty() && a.varying.empty();  // no table was built
    if (unlit) return forward_albedo(scene.fibers[point.fiber], point.color, 0);
    return exp(-a.depth(point.segment, 0));
}

}  // namespace tress
