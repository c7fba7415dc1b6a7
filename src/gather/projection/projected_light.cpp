// SPDX-License-Identifier: MIT
#include "gather/projection/projected_light.h"

#include <algorithm>

#include "core/rng.h"
#include "gather/projection/box_passage.h"
#include "gather/streams.h"
#include "gather/visibility.h"

namespace tress {

void ProjectedLight::operator()(const Scene& scene, const PreparedScene& prepared, const Plan& plan,
                                const Options& options, std::span<const ShadingPoint> points,
                                std::span<const Sampler> samplers, std::span<Rgb> radiance) {
    const Bounds& hair = prepared.projection.bounds;
    if (prepared.probes) probes_.find(scene, prepared, plan, options, points, samplers);
    rays_.clear();
    point_.clear();
    unshadowed_.clear();
    for (uint32_t row = 0; row < points.size(); ++row) {
        const ShadingPoint& point = points[row];
        const bool at_hair = point.fiber != kPolygon;
        const Sampler sampler = stream_of(samplers[row], Stream::projection);
        draw_(scene, prepared, plan, point, sampler, at_hair ? options.projection.directions : options.projection.rays,
              directions_);
        const LightProbe* probe = at_hair && prepared.probes ? &probes_.of(row) : nullptr;
        if (probe && !probe->cells.empty())
            find_seen_light(*probe, prepared.probes->igloo(), point, directions_, seen_);
        else
            by_rays_(scene, prepared, plan, options, point, directions_, seen_);
        const bool by_cells = at_hair || hair.holds(point.position);
        if (by_cells && !seen_.empty()) {
            through_cells_.project(prepared, point, probe, hash(sampler.key, sampler.index), options.isa);
            const CellGap& gap = prepared.projection.gap(at_hair ? Dome::sphere : Dome::hemisphere);
            radiance[row] += through_cells_.light(prepared, seen_, gap.shares, options.isa);
        }
        if (!at_hair || !prepared.probes) send_rays(hair, point, row, by_cells, radiance[row]);
    }
    through_.resize(rays_.size());
    through_hair(prepared, rays_, options, through_);
    for (size_t i = 0; i < rays_.size(); ++i) radiance[point_[i]] += unshadowed_[i] * through_[i];
}

void ProjectedLight::send_rays(const Bounds& hair, const ShadingPoint& point, uint32_t row, bool among_hair_only,
                               Rgb& radiance) {
    for (const SeenLight& light : seen_) {
        if (among_hair_only && !light.among_hair) continue;
        const BoxPassage inside = passage(hair, point.position, light.direction);
        if (inside.enter > std::min(inside.exit, light.distance)) {
            radiance += light.radiance;
            continue;
        }
        rays_.add(point.position, light.direction, light.distance, point.excluded);
        point_.push_back(row);
        unshadowed_.push_back(light.radiance);
    }
}

}  // namespace tress
