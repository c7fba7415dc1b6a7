// SPDX-License-Identifier: MIT
#include "gather/seen_points.h"

#include <tbb/parallel_for.h>

#include <array>

#include "core/camera.h"
#include "core/rng.h"
#include "gather/camera_points.h"

namespace tress {
namespace {

constexpr int kRowsABatch = 8;  // 1024 rays, as in the pixel loop
constexpr uint64_t kKey = hash(0, 0x7365656e);

/// Rays through rows [first, first + kRowsABatch) of the grid, which covers the picture and what its filter reaches
/// beyond.
void add_rays(const Camera& camera, float filter_radius, int first, RayBuffer& to) {
    const CameraFrame frame = camera_frame(camera);
    const double reach = double(filter_radius);
    const double across = (camera.width + 2 * reach) / kSeenRays, down = (camera.height + 2 * reach) / kSeenRays;
    for (int row = first; row < first + kRowsABatch; ++row) {
        for (int column = 0; column < kSeenRays; ++column) {
            const uint64_t key = hash(kKey, uint64_t(row * kSeenRays + column));
            const double x = (column + double(random(key, 0))) * across - reach;
            const double y = (row + double(random(key, 1))) * down - reach;
            to.add(Vec3(camera.from), camera_direction(frame, camera, x, y), kInfinity, {});
        }
    }
}

SeenPoints points_of_rows(const Scene& scene, const PreparedScene& prepared, const Options& options, int first) {
    RayBuffer rays;
    CameraHits hits;
    add_rays(scene.camera, options.film.filter_radius, first, rays);
    find_nearest(prepared, options.isa, rays, hits);
    SeenPoints points;
    for (size_t ray = 0; ray < rays.size(); ++ray) {
        if (hits.id[ray] == kNone) continue;
        if (hits.on_polygon[ray])
            points.polygons.push_back(polygon_point(scene, rays.direction(ray), hit_of(hits, ray)));
        else
            points.hair.push_back(fiber_point(scene, prepared, rays.direction(ray), hit_of(hits, ray)));
    }
    return points;
}

}  // namespace

SeenPoints find_seen_points(const Scene& scene, const PreparedScene& prepared, const Options& options) {
    constexpr int batches = kSeenRays / kRowsABatch;
    static_assert(batches * kRowsABatch == kSeenRays);
    std::array<SeenPoints, batches> found;
    tbb::parallel_for(0, batches,
                      [&](int b) { found[size_t(b)] = points_of_rows(scene, prepared, options, b * kRowsABatch); });
    SeenPoints all;
    for (const SeenPoints& points : found) {
        all.hair.insert(all.hair.end(), points.hair.begin(), points.hair.end());
        all.polygons.insert(all.polygons.end(), points.polygons.begin(), points.polygons.end());
    }
    return all;
}

}  // namespace tress
