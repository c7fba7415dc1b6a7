// SPDX-License-Identifier: MIT
// What the eye sees through the picture, in three steps on one set of arrays: camera rays, their nearest hits, shading
// points. Arrays are kept between calls: one set a thread.
#pragma once

#include <vector>

#include "core/camera.h"
#include "core/sampler.h"
#include "gather/shading_point.h"

namespace tress {

/// Pixels [x0, x1) x [y0, y1).
struct Tile {
    int x0, y0, x1, y1;
};
inline constexpr int kTileSize = 32;  // pixels a side: 1024 rays a batch

/// Tiles that the picture is rendered in, row by row.
int tile_count(const Camera& camera);
Tile tile_of(const Camera& camera, int index);

/// Nearest hits of rays, hair or polygon. Rows belong together by index.
struct CameraHits {
    std::vector<float> t, u, h;  // infinity and kNone: nothing is met
    std::vector<uint32_t> id;
    std::vector<uint8_t> on_polygon;
    std::vector<float> polygon_t, polygon_u, polygon_v;  // scratch
    std::vector<uint32_t> polygon_id;
};

struct CameraPoints {
    RayBuffer rays;
    std::vector<Sampler> samplers;  // one a ray
    std::vector<size_t> pixels;     // one a ray
    CameraHits hits;                // one a ray

    std::vector<ShadingPoint> points;  // one a ray that hits something
    std::vector<uint32_t> row_of_point;
    std::vector<Sampler> point_samplers;
};

/// One ray a pixel of the tile, in place of those from before: sample `sample` of the pixel's filter.
void make_camera_rays(const Scene& scene, const CameraFrame& frame, const Options& options, const Tile& tile,
                      uint32_t sample, CameraPoints& to);

/// Hair first; polygons then only up to the hair, so that the rays end where they hit hair.
void find_nearest(const PreparedScene& prepared, Isa isa, RayBuffer& rays, CameraHits& hits);

/// From the rays and their hits.
void make_points(const Scene& scene, const PreparedScene& prepared, CameraPoints& to);

/// All three steps.
void find_camera_points(const Scene& scene, const PreparedScene& prepared, const CameraFrame& frame,
                        const Options& options, const Tile& tile, uint32_t sample, CameraPoints& to);

inline Hit hit_of(const CameraHits& hits, size_t ray) { return {hits.t[ray], hits.id[ray], hits.u[ray], hits.h[ray]}; }

}  // namespace tress
