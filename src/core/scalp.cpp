// SPDX-License-Identifier: MIT
#include "core/scalp.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/isosurface.h"
#include "core/rng.h"

namespace tress {
namespace {

constexpr float kFieldCell = 0.5f;     // cm; the trilinear field then errs by about 0.01 cm on the skull
constexpr int kNewtonSteps = 2;        // from the coarse mesh, at most 0.05 cm off, to the surface
constexpr float kOffSurface = 1e-3f;   // cm
constexpr float kEarClearance = 0.3f;  // cm

/// The hair line: its height y (cm) over the azimuth from the face (degrees), down the temple to a lock in front of
/// the ear, over the ear, and down behind it to the nape.
struct HairLinePoint {
    float azimuth, height;
};
constexpr HairLinePoint kHairLine[] = {{0, 6.2f},    {22, 6.5f},   {38, 6.0f},  {52, 4.2f},  {66, 1.6f},
                                       {76, -0.4f},  {84, 1.6f},   {96, 2.2f},  {108, 1.4f}, {118, -1.8f},
                                       {132, -5.0f}, {150, -6.9f}, {180, -7.4f}};
constexpr float kHairLineSoftness = 0.4f;  // cm over which the density rises

float hair_line(float azimuth) {
    size_t next = 1;
    while (next + 1 < std::size(kHairLine) && kHairLine[next].azimuth < azimuth) ++next;
    const HairLinePoint &a = kHairLine[next - 1], &b = kHairLine[next];
    const float t = glm::clamp((azimuth - a.azimuth) / (b.azimuth - a.azimuth), 0.0f, 1.0f);
    return a.height + t * t * (3 - 2 * t) * (b.height - a.height);
}

}  // namespace

float scalp_density(const Vec3& p) {
    if (ear_distance(p) < kEarClearance) return 0;
    const float azimuth = glm::degrees(std::atan2(std::abs(p.x), p.z));
    return glm::smoothstep(0.0f, kHairLineSoftness, p.y - hair_line(azimuth));
}

Scalp make_scalp() {
    Scalp scalp;
    scalp.field = sample_grid(head_distance, head_bounds(), kFieldCell);
    const TriangleMesh mesh = isosurface(scalp.field);
    double area = 0;
    for (size_t t = 0; t < mesh.triangles(); ++t) {
        const auto corner = mesh.triangle(t);
        const float density = scalp_density((corner[0] + corner[1] + corner[2]) / 3.0f);
        if (density == 0) continue;
        area += double(density) * length(cross(corner[1] - corner[0], corner[2] - corner[0]));
        scalp.area.push_back(area);
        scalp.corner.insert(scalp.corner.end(), corner.begin(), corner.end());
    }
    return scalp;
}

Roots place_roots(const Scalp& scalp, size_t count, uint64_t key) {
    Roots roots;
    roots.point.resize(count);
    roots.normal.resize(count);
    tbb::parallel_for(size_t(0), count, [&](size_t i) {
        const uint64_t own = hash(key, i);
        const double at = (double(i) + random(own, 0)) / double(count) * scalp.area.back();
        const auto found = std::upper_bound(scalp.area.begin(), scalp.area.end(), at);
        const size_t t = std::min(size_t(found - scalp.area.begin()), scalp.area.size() - 1);
        const float u = std::sqrt(random(own, 1)), v = random(own, 2);
        const Vec3* c = &scalp.corner[3 * t];
        Vec3 p = (1 - u) * c[0] + u * (1 - v) * c[1] + u * v * c[2];
        const Vec3 slope = interpolate(scalp.field, p).gradient;
        for (int step = 0; step < kNewtonSteps; ++step) p -= head_distance(p) / dot(slope, slope) * slope;
        if (std::abs(head_distance(p)) > kOffSurface) p = on_head(p);  // in the crease about an ear
        roots.point[i] = p;
        roots.normal[i] = normalize(slope);
    });
    return roots;
}

}  // namespace tress
