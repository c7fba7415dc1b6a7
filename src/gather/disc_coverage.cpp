// SPDX-License-Identifier: MIT
#include "gather/disc_coverage.h"

#include <array>

#include "accel/queries.h"
#include "core/frame.h"
#include "gather/photon_kernel.h"

namespace tress {
namespace {

constexpr size_t kRim = 8, kSpiral = 64;
constexpr float kRimRadius = 0.9f;  // the cone leaves less than 1 % beyond a chord at this distance
constexpr float kFlatRise = 0.1f;   // from the tangent plane, in radii: a curved surface up to here counts as flat
constexpr float kLeastShare = 0.5f / kSpiral;

using Rim = std::array<Vec2, kRim>;
using Spiral = std::array<Vec2, kSpiral>;

Rim make_rim() {
    Rim rim;
    for (size_t i = 0; i < kRim; ++i) {
        const float angle = 2 * kPi * (float(i) + 0.5f) / kRim;
        rim[i] = kRimRadius * Vec2(std::cos(angle), std::sin(angle));
    }
    return rim;
}

/// Even over the unit disc (Vogel 1979).
Spiral make_spiral() {
    constexpr float kGoldenAngle = 2.39996323f;
    Spiral spiral;
    for (size_t i = 0; i < kSpiral; ++i) {
        const float radius = std::sqrt((float(i) + 0.5f) / kSpiral), angle = kGoldenAngle * float(i);
        spiral[i] = radius * Vec2(std::cos(angle), std::sin(angle));
    }
    return spiral;
}

/// Rays down through the disc at `pattern`, from above what may be of the same surface to below it.
void add_probes(std::span<const Vec2> pattern, const SurfacePoint& point, float radius, RayBuffer& rays) {
    const Frame frame = frame_about(point.normal);
    const float rise = kMostRise * radius + point.rounding;
    for (const Vec2& at : pattern) {
        const Vec3 origin = point.position + radius * (at.x * frame.x + at.y * frame.y) + rise * point.normal;
        rays.add(origin, -point.normal, 2 * rise, {});
    }
}

}  // namespace

void DiscCoverage::trace(const KdTree& tree, Isa isa) {
    for (auto* floats : {&t_, &u_, &v_}) floats->resize(rays_.size());
    triangle_.resize(rays_.size());
    nearest_triangle(tree, rays_.for_mesh(), {t_, triangle_, u_, v_}, isa);
}

DiscCoverage::Probe DiscCoverage::probe(size_t ray, const TriangleMesh& mesh, const SurfacePoint& point) const {
    if (triangle_[ray] == kNone) return {Vec3(0), Vec3(0), 0, false};
    const std::array<Vec3, 3> corner = mesh.triangle(triangle_[ray]);
    Vec3 normal(normalize(cross(DVec3(corner[1]) - DVec3(corner[0]), DVec3(corner[2]) - DVec3(corner[0]))));
    if (dot(normal, point.normal) < 0) normal = -normal;
    const Vec3 chord = rays_.origin(ray) + t_[ray] * rays_.direction(ray) - point.position;
    const float distance = glm::length(chord);
    return {chord, normal, distance, on_same_surface(point, chord, distance, normal)};
}

void DiscCoverage::operator()(const KdTree& tree, const TriangleMesh& mesh, Isa isa,
                              std::span<const SurfacePoint> points, std::span<const float> radius,
                              std::span<float> share) {
    static const Rim rim = make_rim();
    static const Spiral spiral = make_spiral();
    std::fill(share.begin(), share.end(), 1.0f);
    if (tree.empty()) return;

    rays_.clear();
    for (size_t i = 0; i < points.size(); ++i) add_probes(rim, points[i], radius[i], rays_);
    trace(tree, isa);
    cut_.clear();
    for (uint32_t i = 0; i < points.size(); ++i) {
        const auto is_flat = [&](size_t ray) {
            const Probe p = probe(ray, mesh, points[i]);
            return p.on_surface &&
                   std::abs(dot(p.chord, points[i].normal)) <= kFlatRise * radius[i] + points[i].rounding;
        };
        bool whole = true;
        for (size_t r = 0; r < kRim && whole; ++r) whole = is_flat(i * kRim + r);
        if (!whole) cut_.push_back(i);
    }

    rays_.clear();
    for (const uint32_t i : cut_) add_probes(spiral, points[i], radius[i], rays_);
    trace(tree, isa);
    float of_disc = 0;
    for (const Vec2& at : spiral) of_disc += cone(dot(at, at), 1);
    for (size_t c = 0; c < cut_.size(); ++c) {
        const uint32_t i = cut_[c];
        float covered = 0;
        for (size_t s = 0; s < kSpiral; ++s) {
            const Probe p = probe(c * kSpiral + s, mesh, points[i]);
            if (p.on_surface) covered += cone(square(p.distance), radius[i]) / dot(p.normal, points[i].normal);
        }
        share[i] = glm::max(covered / of_disc, kLeastShare);
    }
}

}  // namespace tress
