// SPDX-License-Identifier: MIT
// One sample of every pixel of a tile, stage by stage on batches: camera rays, shading points, light.
#pragma once

#include <vector>

#include "core/film.h"
#include "gather/camera_points.h"
#include "gather/crossing_light.h"
#include "gather/direct_light.h"
#include "gather/paths/path_tracer.h"
#include "gather/photons/photon_display.h"
#include "gather/polygon_light.h"
#include "gather/projection/projected_light.h"
#include "gather/stage_clock.h"

namespace tress {

struct TileContext {
    const Scene& scene;
    const PreparedScene& prepared;
    const Plan& plan;
    const Options& options;
    CameraFrame camera;
};

/// Arrays kept between tiles, one set a thread. Rows of one batch belong together by index.
struct TileScratch {
    CameraPoints camera;             // one ray a pixel
    std::vector<FilmSample> film;    // one a pixel
    std::vector<Rgb> radiance;       // one a point
    std::vector<LightByType> light;  // one a point
    DirectLight direct;
    ProjectedLight projected;
    GatherRays gather;
    PolygonLight polygon_light;
    CrossingLight crossing_light;
    PhotonDisplay photon_display;
    PathTracer paths;
};

void render_tile(const TileContext& context, const Tile& tile, uint32_t sample, TileScratch& scratch,
                 StageClocks& clocks, Film& film);

}  // namespace tress
