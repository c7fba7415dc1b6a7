// SPDX-License-Identifier: MIT
#include "core/head.h"

#include "core/isosurface.h"
#include "core/scalar_grid.h"

namespace tress {
namespace {

float smooth_union(float a, float b, float blend) {
    const float h = glm::max(blend - std::abs(a - b), 0.0f) / blend;
    return glm::min(a, b) - 0.25f * blend * h * h;
}

float smooth_intersection(float a, float b, float blend) { return -smooth_union(-a, -b, blend); }
float smooth_difference(float a, float b, float blend) { return smooth_intersection(a, -b, blend); }

/// First-order distance to an ellipsoid: exact on it, and for spheres.
float ellipsoid(const Vec3& p, const Vec3& center, const Vec3& radii) {
    const Vec3 scaled = (p - center) / radii;
    const float k0 = length(scaled), k1 = length(scaled / radii);
    if (k1 < 1e-6f) return -min_component(radii);
    return k0 * (k0 - 1) / k1;
}

float sphere(const Vec3& p, const Vec3& center, float radius) { return distance(p, center) - radius; }

/// Capsule whose radius runs linearly from r0 at a to r1 at b.
float cone(const Vec3& p, const Vec3& a, const Vec3& b, float r0, float r1) {
    const Vec3 axis = b - a;
    const float t = glm::clamp(dot(p - a, axis) / dot(axis, axis), 0.0f, 1.0f);
    return distance(p, a + t * axis) - (r0 + t * (r1 - r0));
}

/// |x|, rounded at 0 so that what is mirrored joins without a crease.
Vec3 mirrored(const Vec3& p) { return {std::sqrt(p.x * p.x + 0.16f), p.y, p.z}; }

constexpr float kLipBend = 0.2f;  // 1/cm: lips follow the curve of the teeth

float skull(const Vec3& p) {
    float d = ellipsoid(p, {0, 3.1f, -1.3f}, {7.5f, 7.9f, 9.3f});
    d = smooth_union(d, ellipsoid(p, {0, -2.2f, 2.1f}, {5.9f, 7.4f, 6.1f}), 2.5f);
    d = smooth_union(d, cone(p, {4.4f, -4.4f, 0.2f}, {0.8f, -9.0f, 5.4f}, 1.6f, 1.6f), 3.0f);
    return smooth_union(d, ellipsoid(p, {0, -9.3f, 6.4f}, {1.9f, 1.6f, 1.5f}), 2.4f);
}

float add_features(float d, const Vec3& p) {
    d = smooth_union(d, cone(p, {1.1f, 2.2f, 7.3f}, {4.3f, 2.6f, 5.6f}, 0.5f, 0.4f), 2.4f);  // brow
    d = smooth_union(d, ellipsoid(p, {3.6f, -2.6f, 5.1f}, {1.9f, 1.6f, 1.8f}), 2.6f);        // cheek
    d = smooth_union(d, ellipsoid(p, {2.8f, -5.4f, 2.9f}, {2.3f, 2.8f, 3.0f}), 3.2f);        // lower cheek
    d = smooth_difference(d, ellipsoid(p, {3.0f, 0.5f, 8.7f}, {1.9f, 1.1f, 1.7f}), 1.3f);    // eye socket
    d = smooth_union(d, sphere(p, {3.0f, 0.35f, 5.95f}, 1.42f), 0.3f);                       // closed lid
    d = smooth_union(d, cone(p, {0, 1.8f, 7.2f}, {0, -2.9f, 9.3f}, 0.6f, 0.85f), 1.3f);      // nose
    d = smooth_union(d, ellipsoid(p, {0.85f, -3.2f, 8.3f}, {0.65f, 0.55f, 0.9f}), 0.8f);     // nostril
    d = smooth_union(d, ellipsoid(p, {0, -6.2f, 6.0f}, {2.7f, 1.9f, 1.9f}), 1.6f);           // mouth
    const Vec3 bent(p.x, p.y, p.z + kLipBend * p.x * p.x);
    d = smooth_union(d, ellipsoid(bent, {0, -5.8f, 7.8f}, {2.3f, 0.42f, 0.6f}), 0.6f);   // upper lip
    d = smooth_union(d, ellipsoid(bent, {0, -6.7f, 7.75f}, {1.9f, 0.5f, 0.65f}), 0.4f);  // lower lip
    return d;
}

/// Neck, shoulders and chest, cut flat below.
float torso(const Vec3& p) {
    float d = cone(p, {0, -4.0f, -2.4f}, {0, -18.0f, -4.2f}, 4.6f, 4.9f);
    d = smooth_union(d, cone(p, {2.5f, -18.2f, -4.8f}, {16.0f, -20.6f, -4.2f}, 3.4f, 4.0f), 4.0f);
    d = smooth_union(d, ellipsoid(p, {0, -27.0f, -3.2f}, {17.5f, 10.0f, 8.4f}), 4.0f);
    return smooth_intersection(d, -30.0f - p.y, 1.0f);
}

constexpr float kMeshCell = 0.4f;     // cm: 55 thousand triangles, and lids and lips keep their shape
constexpr float kDifference = 0.02f;  // cm, of the central differences: well below the smallest feature
constexpr float kEarRim = 0.2f;       // cm, the roundness of its edge
constexpr int kNewtonSteps = 3;

Vec3 gradient(const Vec3& p) {
    const Vec3 x(kDifference, 0, 0), y(0, kDifference, 0), z(0, 0, kDifference);
    const Vec3 difference(head_distance(p + x) - head_distance(p - x), head_distance(p + y) - head_distance(p - y),
                          head_distance(p + z) - head_distance(p - z));
    return difference / (2 * kDifference);
}

}  // namespace

float ear_distance(const Vec3& p) {
    const Vec3 q = mirrored(p);
    // Turned so that x leaves the head: the ear leans back at the top and stands off behind.
    const Vec3 local = q - Vec3(7.5f, -0.9f, -1.2f);
    const Vec3 ear(0.92f * local.x + 0.39f * local.z, 0.98f * local.y - 0.2f * local.z,
                   0.92f * (local.z + 0.2f * local.y) - 0.39f * local.x);
    const float shell = ellipsoid(ear, {0, 0, 0}, {0.55f, 2.7f, 1.55f}) - kEarRim;
    return smooth_difference(shell, ellipsoid(ear, {0.85f, 0.1f, 0.1f}, {0.55f, 1.9f, 1.0f}), 0.5f);
}

float head_distance(const Vec3& p) {
    const Vec3 q = mirrored(p);
    const float head = smooth_union(add_features(skull(q), q), ear_distance(p), 0.8f);
    return smooth_union(head, torso(q), 2.2f);
}

Vec3 head_normal(const Vec3& p) { return normalize(gradient(p)); }

Vec3 on_head(const Vec3& p) {
    Vec3 q = p;
    for (int step = 0; step < kNewtonSteps; ++step) {
        const Vec3 slope = gradient(q);
        q -= head_distance(q) / dot(slope, slope) * slope;
    }
    return q;
}

Bounds head_bounds() { return {{-22.0f, -31.5f, -15.0f}, {22.0f, 12.5f, 12.5f}}; }

TriangleMesh make_head() {
    TriangleMesh mesh = isosurface(sample_grid(head_distance, head_bounds(), kMeshCell));
    mesh.normal.resize(mesh.vertices());
    tbb::parallel_for(size_t(0), mesh.vertices(), [&](size_t v) {
        const Vec3 p = on_head(mesh.vertex(v));
        mesh.x[v] = p.x;
        mesh.y[v] = p.y;
        mesh.z[v] = p.z;
        mesh.normal[v] = head_normal(p);
    });
    return mesh;
}

}  // namespace tress
