// SPDX-License-Identifier: MIT
#include "gather/photons/disc_coverage.h"

#include <array>

#include "accel/queries.h"
#include "core/frame.h"
#include "gather/photons/photon_kernel.h"

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

}  // namespace

/// Rays down through the disc at `pattern`, from above what may be of the same surface to below it.
void DiscCoverage::add(std::span<const Vec2> pattern, uint32_t point, const SurfacePoint& about, float radius) {
    const Frame frame = frame_about(about.normal);
    const float rise = kMostRise * radius + about.rounding;
    for (const Vec2& at : pattern) {
        const Vec3 origin = about.position + radius * (at.x * frame.x + at.y * frame.y) + rise * about.normal;
        rays_.add(origin, -about.normal, 2 * rise, {});
        point_.push_back(point);
        length_.push_back(2 * rise);
    }
}

/// What is met first may be another surface, as where things stand on each other: rays go on through some of those.
void DiscCoverage::trace(const KdTree& tree, const TriangleMesh& mesh, Isa isa, std::span<const SurfacePoint> points) {
    constexpr int kMostLayers = 4;
    probe_.assign(rays_.size(), Probe{});
    ray_.resize(rays_.size());
    for (uint32_t i = 0; i < ray_.size(); ++i) ray_[i] = i;
    for (int layer = 0; layer < kMostLayers && !ray_.empty(); ++layer) {
        for (auto* floats : {&t_, &u_, &v_}) floats->resize(ray_.size());
        triangle_.resize(ray_.size());
        nearest_triangle(tree, rays_.for_mesh(), {t_, triangle_, u_, v_}, isa);
        further_.clear();
        further_ray_.clear();
        for (size_t i = 0; i < ray_.size(); ++i) {
            if (triangle_[i] == kNone) continue;
            const SurfacePoint& point = points[point_[ray_[i]]];
            const std::array<Vec3, 3> corner = mesh.triangle(triangle_[i]);
            Vec3 normal(normalize(cross(DVec3(corner[1]) - DVec3(corner[0]), DVec3(corner[2]) - DVec3(corner[0]))));
            if (dot(normal, point.normal) < 0) normal = -normal;
            const Vec3 at = rays_.origin(i) + t_[i] * rays_.direction(i), chord = at - point.position;
            const float distance = glm::length(chord);
            if (on_same_surface(point, chord, distance, normal)) {
                probe_[ray_[i]] = {distance, dot(normal, point.normal), dot(chord, point.normal)};
                continue;
            }
            float& left = length_[ray_[i]];
            left -= t_[i];
            if (!(left > 0)) continue;
            further_.add(at, rays_.direction(i), left, {.triangle = triangle_[i]});
            further_ray_.push_back(ray_[i]);
        }
        std::swap(rays_, further_);
        std::swap(ray_, further_ray_);
    }
    rays_.clear();
    point_.clear();
    length_.clear();
}

void DiscCoverage::operator()(const KdTree& tree, const TriangleMesh& mesh, Isa isa,
                              std::span<const SurfacePoint> points, std::span<const float> radius,
                              std::span<float> share) {
    static const Rim rim = make_rim();
    static const Spiral spiral = make_spiral();
    std::fill(share.begin(), share.end(), 1.0f);
    if (tree.empty()) return;

    for (uint32_t i = 0; i < points.size(); ++i) add(rim, i, points[i], radius[i]);
    trace(tree, mesh, isa, points);
    cut_.clear();
    for (uint32_t i = 0; i < points.size(); ++i) {
        const float flat = kFlatRise * radius[i] + points[i].rounding;
        const auto is_flat = [&](const Probe& p) { return p.distance < kInfinity && std::abs(p.rise) <= flat; };
        const auto first = probe_.begin() + ptrdiff_t(i * kRim);
        if (!std::all_of(first, first + kRim, is_flat)) cut_.push_back(i);
    }

    for (const uint32_t i : cut_) add(spiral, i, points[i], radius[i]);
    trace(tree, mesh, isa, points);
    float of_disc = 0;
    for (const Vec2& at : spiral) of_disc += cone(dot(at, at), 1);
    for (size_t c = 0; c < cut_.size(); ++c) {
        const uint32_t i = cut_[c];
        float covered = 0;
        for (size_t s = 0; s < kSpiral; ++s) {
            const Probe& p = probe_[c * kSpiral + s];
            if (p.distance < kInfinity) covered += cone(square(p.distance), radius[i]) / p.cosine;
        }
        share[i] = glm::max(covered / of_disc, kLeastShare);
    }
}

}  // namespace tress
