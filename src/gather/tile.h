// SPDX-License-Identifier: MIT
// One sample of every pixel of a tile, stage by stage on batches: camera rays, shading points, light.
#pragma once

#include <vector>

#include "core/camera.h"
#include "core/film.h"
#include "gather/crossing_light.h"
#include "gather/direct_light.h"
#include "gather/paths/path_tracer.h"
#include "gather/photons/photon_display.h"
#include "gather/polygon_light.h"
#include "gather/stage_clock.h"

namespace tress {

/// Pixels [x0, x1) x [y0, y1).
struct Tile {
    int x0, y0, x1, y1;
};

struct TileContext {
    const Scene& scene;
    const PreparedScene& prepared;
    const Plan& plan;
    const Options& options;
    CameraFrame camera;
};

/// Arrays kept between tiles, one set a thread. Rows of one batch belong together by index.
struct TileScratch {
    RayBuffer rays;  // one a pixel
    std::vector<Sampler> samplers;
    std::vector<size_t> pixels;
    std::vector<float> t, u, h;  // nearest hits, hair or polygon
    std::vector<uint32_t> id;
    std::vector<uint8_t> on_polygon;
    std::vector<float> polygon_t, polygon_u, polygon_v;
    std::vector<uint32_t> polygon_id;

    std::vector<FilmSample> film;      // one a pixel
    std::vector<ShadingPoint> points;  // one a pixel that hits something
    std::vector<uint32_t> row_of_point;
    std::vector<Sampler> point_samplers;
    std::vector<Rgb> radiance;       // one a point
    std::vector<LightByType> light;  // one a point
    DirectLight direct;
    GatherRays gather;
    PolygonLight polygon_light;
    CrossingLight crossing_light;
    PhotonDisplay photon_display;
    PathTracer paths;
};

void render_tile(const TileContext& context, const Tile& tile, uint32_t sample, TileScratch& scratch,
                 StageClocks& clocks, Film& film);

}  // namespace tress
