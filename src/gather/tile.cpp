// SPDX-License-Identifier: MIT
#include "gather/tile.h"

#include "core/rng.h"
#include "core/sampling.h"

namespace tress {
namespace {

constexpr uint32_t kFilterDimension = 0;

void make_camera_rays(const TileContext& context, const Tile& tile, uint32_t sample, TileScratch& s) {
    s.rays.clear();
    s.samplers.clear();
    s.pixels.clear();
    const Camera& camera = context.scene.camera;
    const float radius = context.options.film.filter_radius;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const size_t pixel = size_t(y) * size_t(camera.width) + size_t(x);
            const Sampler sampler{hash(context.options.seed, pixel), sample};
            const Vec2 u = sampler.get2(kFilterDimension);
            const double dx = double(sample_blackman_harris(u.x, radius));
            const double dy = double(sample_blackman_harris(u.y, radius));
            const Vec3 direction = camera_direction(context.camera, camera, x + 0.5 + dx, y + 0.5 + dy);
            s.rays.add(Vec3(camera.from), direction, kInfinity, {});
            s.samplers.push_back(sampler);
            s.pixels.push_back(pixel);
        }
    }
}

/// Hair first; polygons then only up to the hair.
void find_nearest(const TileContext& context, TileScratch& s) {
    const size_t n = s.rays.size();
    for (auto* floats : {&s.t, &s.u, &s.h, &s.polygon_t, &s.polygon_u, &s.polygon_v}) floats->assign(n, kInfinity);
    for (auto* ids : {&s.id, &s.polygon_id}) ids->assign(n, kNone);
    s.on_polygon.assign(n, 0);

    const PreparedScene& prepared = context.prepared;
    if (!prepared.hair.empty())
        nearest_segment(prepared.hair, s.rays.for_hair(), {s.t, s.id, s.u, s.h}, context.options.isa);
    if (prepared.mesh.empty()) return;
    for (size_t i = 0; i < n; ++i) s.rays.set_far(i, s.t[i]);
    nearest_triangle(prepared.mesh, s.rays.for_mesh(), {s.polygon_t, s.polygon_id, s.polygon_u, s.polygon_v},
                     context.options.isa);
    for (size_t i = 0; i < n; ++i) {
        if (s.polygon_id[i] == kNone) continue;
        s.t[i] = s.polygon_t[i], s.u[i] = s.polygon_u[i], s.h[i] = s.polygon_v[i], s.id[i] = s.polygon_id[i];
        s.on_polygon[i] = 1;
    }
}

Rgb background(const TileContext& context, const Vec3& direction) {
    Rgb sum(0);
    if (!context.plan.background) return sum;
    for (const uint32_t light : context.plan.environments)
        sum += radiance(*context.prepared.environment[light], direction);
    return sum;
}

void make_points(const TileContext& context, TileScratch& s) {
    s.film.assign(s.rays.size(), FilmSample{});
    s.points.clear();
    s.row_of_point.clear();
    s.point_samplers.clear();
    for (uint32_t row = 0; row < s.rays.size(); ++row) {
        const Vec3 direction = s.rays.direction(row);
        if (s.id[row] == kNone) {
            s.film[row].background = background(context, direction);
            continue;
        }
        const Hit hit{s.t[row], s.id[row], s.u[row], s.h[row]};
        s.points.push_back(s.on_polygon[row] ? polygon_point(context.scene, direction, hit)
                                             : fiber_point(context.scene, context.prepared, direction, hit));
        s.row_of_point.push_back(row);
        s.point_samplers.push_back(s.samplers[row]);
        s.film[row].albedo = layer_albedo(context.scene, context.prepared, s.points.back());
        s.film[row].depth = hit.t;
        s.film[row].hit = true;
        s.film[row].on_hair = !s.on_polygon[row];
    }
}

/// Light of every type, stage by stage, into the sums of each point.
class TileLight {
public:
    TileLight(const TileContext& context, TileScratch& scratch, StageClocks& clocks)
        : c_(context), s_(scratch), clocks_(clocks) {
        s_.light.assign(s_.points.size(), LightByType{});
    }

    void operator()() {
        const Plan& plan = c_.plan;
        const auto lights = [&](const std::vector<uint32_t>& from) {
            return
                [&] { s_.direct(c_.scene, c_.prepared, c_.options, from, s_.points, s_.point_samplers, s_.radiance); };
        };
        if (plan.direct) one_type(LoopStage::type1, PathType::type1, lights(plan.lamps));
        if (plan.sky) one_type(LoopStage::sky, PathType::type2, lights(plan.environments));
        if (plan.gather_rays()) gather();
        if (any(plan.photon_display)) {
            const StageTimer timer(clocks_, LoopStage::photon_display);
            s_.photon_display(c_.scene, c_.prepared, c_.options, s_.points, s_.light);
        }
        if (any(plan.paths)) {
            const StageTimer timer(clocks_, LoopStage::paths);
            s_.paths(c_.scene, c_.prepared, plan, c_.options, s_.points, s_.point_samplers, s_.light);
        }
    }

private:
    void gather() {
        {
            const StageTimer timer(clocks_, LoopStage::gather_rays);
            make_gather_rays(c_.scene, c_.prepared, c_.options, s_.points, s_.point_samplers, s_.gather);
        }
        if (c_.plan.polygon_gather)
            one_type(LoopStage::polygon_gather, PathType::type2,
                     [&] { s_.polygon_light(c_.scene, c_.prepared, c_.options, s_.gather, s_.radiance); });
        if (c_.plan.crossing_gather)
            one_type(LoopStage::crossing_gather, PathType::type3, [&] {
                s_.crossing_light(c_.scene, c_.prepared, c_.options, c_.plan.lamps, s_.gather, s_.radiance);
            });
    }

    /// `add` adds to s_.radiance.
    template <class Add>
    void one_type(LoopStage stage, PathType type, const Add& add) {
        const StageTimer timer(clocks_, stage);
        s_.radiance.assign(s_.points.size(), Rgb(0));
        add();
        for (size_t i = 0; i < s_.points.size(); ++i) s_.light[i][size_t(index_of(type))] += s_.radiance[i];
    }

    const TileContext& c_;
    TileScratch& s_;
    StageClocks& clocks_;
};

}  // namespace

void render_tile(const TileContext& context, const Tile& tile, uint32_t sample, TileScratch& s, StageClocks& clocks,
                 Film& film) {
    {
        const StageTimer timer(clocks, LoopStage::camera_rays);
        make_camera_rays(context, tile, sample, s);
        find_nearest(context, s);
        make_points(context, s);
    }
    TileLight(context, s, clocks)();
    for (size_t i = 0; i < s.points.size(); ++i) s.film[s.row_of_point[i]].light = s.light[i];
    for (size_t row = 0; row < s.film.size(); ++row) add(film, s.pixels[row], s.film[row]);
}

}  // namespace tress
