// SPDX-License-Identifier: MIT
#include "gather/gather_rays.h"

#include "core/light_sample.h"
#include "gather/streams.h"

namespace tress {
namespace {

constexpr uint32_t kDirectionDimension = 0;

void clear(GatherRays& g) {
    g.rays.clear();
    g.point.clear();
    g.samplers.clear();
    g.weight.clear();
}

/// Adds the ray unless it can bring nothing: from below a polygon's horizon, or with a density that underflows.
void add_ray(const Scene& scene, const ShadingPoint& point, uint32_t row, const Sampler& sampler, float share,
             GatherRays& to) {
    const ScatteredDirection drawn = draw_scattering(scene, point, sampler.get4(kDirectionDimension));
    const Rgb weight = drawn.scattering.value() * (share / drawn.scattering.pdf);
    if (!is_finite(weight) || !(max_component(weight) > 0)) return;
    to.rays.add(point.position, drawn.direction, kInfinity, point.excluded);
    to.point.push_back(row);
    to.samplers.push_back(sampler);
    to.weight.push_back(weight);
}

void find_polygons(const PreparedScene& prepared, Isa isa, GatherRays& to) {
    to.t.assign(to.size(), kInfinity);
    to.polygon.assign(to.size(), kNone);
    to.u.assign(to.size(), 0);
    to.v.assign(to.size(), 0);
    if (prepared.mesh.empty()) return;
    nearest_triangle(prepared.mesh, to.rays.for_mesh(), {to.t, to.polygon, to.u, to.v}, isa);
    for (size_t ray = 0; ray < to.size(); ++ray) to.rays.set_far(ray, to.t[ray]);
}

}  // namespace

void make_gather_rays(const Scene& scene, const PreparedScene& prepared, const Options& options,
                      std::span<const ShadingPoint> points, std::span<const Sampler> samplers, GatherRays& to) {
    clear(to);
    const uint32_t rays = uint32_t(options.gather.rays);
    for (uint32_t row = 0; row < points.size(); ++row) {
        const Sampler stream = stream_of(samplers[row], Stream::gather);
        for (uint32_t j = 0; j < rays; ++j)
            add_ray(scene, points[row], row, {stream.key, stream.index * rays + j}, 1 / float(rays), to);
    }
    find_polygons(prepared, options.isa, to);
}

}  // namespace tress
