// SPDX-License-Identifier: MIT
#include "gather/camera_points.h"

#include <algorithm>

#include "core/rng.h"
#include "core/sampling.h"

namespace tress {
namespace {

constexpr uint32_t kFilterDimension = 0;

int tiles_across(int pixels) { return (pixels + kTileSize - 1) / kTileSize; }

void clear(CameraHits& hits, size_t n) {
    for (auto* floats : {&hits.t, &hits.u, &hits.h, &hits.polygon_t, &hits.polygon_u, &hits.polygon_v})
        floats->assign(n, kInfinity);
    for (auto* ids : {&hits.id, &hits.polygon_id}) ids->assign(n, kNone);
    hits.on_polygon.assign(n, 0);
}

}  // namespace

int tile_count(const Camera& camera) { return tiles_across(camera.width) * tiles_across(camera.height); }

Tile tile_of(const Camera& camera, int index) {
    const int across = tiles_across(camera.width);
    const int x = index % across * kTileSize, y = index / across * kTileSize;
    return {x, y, std::min(x + kTileSize, camera.width), std::min(y + kTileSize, camera.height)};
}

void make_camera_rays(const Scene& scene, const CameraFrame& frame, const Options& options, const Tile& tile,
                      uint32_t sample, CameraPoints& to) {
    to.rays.clear();
    to.samplers.clear();
    to.pixels.clear();
    const Camera& camera = scene.camera;
    const float radius = options.film.filter_radius;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const size_t pixel = size_t(y) * size_t(camera.width) + size_t(x);
            const Sampler sampler{hash(options.seed, pixel), sample};
            const Vec2 u = sampler.get2(kFilterDimension);
            const double dx = double(sample_blackman_harris(u.x, radius));
            const double dy = double(sample_blackman_harris(u.y, radius));
            const Vec3 direction = camera_direction(frame, camera, x + 0.5 + dx, y + 0.5 + dy);
            to.rays.add(Vec3(camera.from), direction, kInfinity, {});
            to.samplers.push_back(sampler);
            to.pixels.push_back(pixel);
        }
    }
}

void find_nearest(const PreparedScene& prepared, Isa isa, RayBuffer& rays, CameraHits& hits) {
    const size_t n = rays.size();
    clear(hits, n);
    if (!prepared.hair.empty()) nearest_segment(prepared.hair, rays.for_hair(), {hits.t, hits.id, hits.u, hits.h}, isa);
    if (prepared.mesh.empty()) return;
    for (size_t i = 0; i < n; ++i) rays.set_far(i, hits.t[i]);
    nearest_triangle(prepared.mesh, rays.for_mesh(), {hits.polygon_t, hits.polygon_id, hits.polygon_u, hits.polygon_v},
                     isa);
    for (size_t i = 0; i < n; ++i) {
        if (hits.polygon_id[i] == kNone) continue;
        hits.t[i] = hits.polygon_t[i], hits.u[i] = hits.polygon_u[i], hits.h[i] = hits.polygon_v[i];
        hits.id[i] = hits.polygon_id[i];
        hits.on_polygon[i] = 1;
    }
}

void make_points(const Scene& scene, const PreparedScene& prepared, CameraPoints& to) {
    to.points.clear();
    to.row_of_point.clear();
    to.point_samplers.clear();
    for (uint32_t row = 0; row < to.rays.size(); ++row) {
        if (to.hits.id[row] == kNone) continue;
        const Vec3 direction = to.rays.direction(row);
        const Hit hit = hit_of(to.hits, row);
        to.points.push_back(to.hits.on_polygon[row] ? polygon_point(scene, direction, hit)
                                                    : fiber_point(scene, prepared, direction, hit));
        to.row_of_point.push_back(row);
        to.point_samplers.push_back(to.samplers[row]);
    }
}

void find_camera_points(const Scene& scene, const PreparedScene& prepared, const CameraFrame& frame,
                        const Options& options, const Tile& tile, uint32_t sample, CameraPoints& to) {
    make_camera_rays(scene, frame, options, tile, sample, to);
    find_nearest(prepared, options.isa, to.rays, to.hits);
    make_points(scene, prepared, to);
}

}  // namespace tress
