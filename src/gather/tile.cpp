// SPDX-License-Identifier: MIT
#include "gather/tile.h"

namespace tress {
namespace {

Rgb background(const TileContext& context, const Vec3& direction) {
    Rgb sum(0);
    if (!context.plan.background) return sum;
    for (const uint32_t light : context.plan.environments)
        sum += radiance(*context.prepared.environment[light], direction);
    return sum;
}

/// What the picture shows of the scene besides its light.
void fill_film(const TileContext& context, TileScratch& s) {
    const CameraPoints& seen = s.camera;
    s.film.assign(seen.rays.size(), FilmSample{});
    for (size_t row = 0; row < s.film.size(); ++row)
        if (seen.hits.id[row] == kNone) s.film[row].background = background(context, seen.rays.direction(row));
    for (size_t i = 0; i < seen.points.size(); ++i) {
        const ShadingPoint& point = seen.points[i];
        FilmSample& sample = s.film[seen.row_of_point[i]];
        sample.albedo = layer_albedo(context.scene, context.prepared, point);
        sample.depth = point.depth;
        sample.hit = true;
        sample.on_hair = point.fiber != kPolygon;
    }
}

/// Light of every type, stage by stage, into the sums of each point.
class TileLight {
public:
    TileLight(const TileContext& context, TileScratch& scratch, StageClocks& clocks)
        : c_(context),
          s_(scratch),
          points_(scratch.camera.points),
          samplers_(scratch.camera.point_samplers),
          clocks_(clocks) {
        s_.light.assign(points_.size(), LightByType{});
    }

    void operator()() {
        const Plan& plan = c_.plan;
        const auto lights = [&](const std::vector<uint32_t>& from, const LampMaps* maps) {
            return [&, maps] {
                s_.direct(c_.scene, c_.prepared, c_.options, from, maps, points_, samplers_, s_.radiance);
            };
        };
        if (plan.direct) one_type(LoopStage::type1, PathType::type1, lights(plan.lamps, maps(plan.lamp_maps)));
        if (plan.projection)
            one_type(LoopStage::projection, PathType::type2,
                     [&] { s_.projected(c_.scene, c_.prepared, plan, c_.options, points_, samplers_, s_.radiance); });
        else if (plan.sky)
            one_type(LoopStage::sky, PathType::type2, lights(plan.environments, nullptr));
        if (plan.gather_rays()) gather();
        if (any(plan.photon_display)) {
            const StageTimer timer(clocks_, LoopStage::photon_display);
            s_.photon_display(c_.scene, c_.prepared, c_.options, points_, s_.light);
        }
        if (any(plan.paths)) {
            const StageTimer timer(clocks_, LoopStage::paths);
            s_.paths(c_.scene, c_.prepared, plan, c_.options, points_, samplers_, s_.light);
        }
    }

private:
    const LampMaps* maps(const std::optional<MapKind>& kind) const {
        return kind ? &c_.prepared.shadow_maps[size_t(*kind)] : nullptr;
    }

    void gather() {
        {
            const StageTimer timer(clocks_, LoopStage::gather_rays);
            make_gather_rays(c_.scene, c_.prepared, c_.options, points_, samplers_, s_.gather);
        }
        if (c_.plan.polygon_gather && !c_.plan.projection)
            one_type(LoopStage::polygon_gather, PathType::type2,
                     [&] { s_.polygon_light(c_.scene, c_.prepared, c_.options, s_.gather, s_.radiance); });
        if (c_.plan.crossing_gather)
            one_type(LoopStage::crossing_gather, PathType::type3, [&] {
                s_.crossing_light(c_.scene, c_.prepared, c_.options, c_.plan.lamps, maps(c_.plan.crossing_maps),
                                  s_.gather, s_.radiance);
            });
    }

    /// `add` adds to s_.radiance.
    template <class Add>
    void one_type(LoopStage stage, PathType type, const Add& add) {
        const StageTimer timer(clocks_, stage);
        s_.radiance.assign(points_.size(), Rgb(0));
        add();
        for (size_t i = 0; i < points_.size(); ++i) s_.light[i][size_t(index_of(type))] += s_.radiance[i];
    }

    const TileContext& c_;
    TileScratch& s_;
    std::span<const ShadingPoint> points_;
    std::span<const Sampler> samplers_;
    StageClocks& clocks_;
};

}  // namespace

void render_tile(const TileContext& context, const Tile& tile, uint32_t sample, TileScratch& s, StageClocks& clocks,
                 Film& film) {
    {
        const StageTimer timer(clocks, LoopStage::camera_rays);
        find_camera_points(context.scene, context.prepared, context.camera, context.options, tile, sample, s.camera);
        fill_film(context, s);
    }
    TileLight(context, s, clocks)();
    const CameraPoints& seen = s.camera;
    for (size_t i = 0; i < seen.points.size(); ++i) s.film[seen.row_of_point[i]].light = s.light[i];
    for (size_t row = 0; row < s.film.size(); ++row) add(film, seen.pixels[row], s.film[row]);
}

}  // namespace tress
