// SPDX-License-Identifier: MIT
#include "gather/projection/probes_of_points.h"

#include "accel/queries.h"
#include "core/rng.h"
#include "gather/projection/make_light_probe.h"

namespace tress {
namespace {

constexpr uint64_t kChoice = 0x70726f62;

/// Of the corners that are left, by weight; -1: none.
int draw_corner(const ProbeCube& cube, uint32_t passed_over, float u) {
    float sum = 0;
    int last = -1;
    for (int i = 0; i < 8; ++i)
        if (!(passed_over >> i & 1)) sum += cube.weight(i);
    float below = 0;
    for (int i = 0; i < 8 && !(last >= 0 && below > u * sum); ++i) {
        if (passed_over >> i & 1 || !(cube.weight(i) > 0)) continue;
        below += cube.weight(i);
        last = i;
    }
    return last;
}

}  // namespace

LightProbe ProbesOfPoints::make_at_corner(const Scene& scene, const PreparedScene& prepared, const Plan& plan,
                                          const Options& options, const ProbeCube& cube, int corner) {
    const Igloo& igloo = prepared.probes->igloo();
    LightProbe probe =
        make_light_probe(scene, prepared, plan, igloo, cube.corner(corner), Excluded{}, cube.key(corner), options.isa);
    if (!plan.far_field) return probe;
    Viewpoint from{probe.position, probe.frame, Dome::sphere, {}};
    if (!probe.cells.empty()) {
        const Igloo& of_hair = prepared.projection.igloo;
        projection_kernels(options.isa).find_sight(probe, igloo, of_hair, from, sight_);
        from.sight = std::span(sight_).first(of_hair.cells_of(from.dome));
    }
    probe.far = find_far_hair(prepared.projection, from, cube.grid.size, options.isa, scratch_);
    return probe;
}

void ProbesOfPoints::find(const Scene& scene, const PreparedScene& prepared, const Plan& plan, const Options& options,
                          std::span<const ShadingPoint> points, std::span<const Sampler> samplers) {
    LightProbes& probes = *prepared.probes;
    probe_.resize(points.size());
    own_.clear();
    searches_.clear();
    for (uint32_t i = 0; i < points.size(); ++i)
        if (points[i].fiber != kPolygon)
            searches_.push_back({i, cube_at(probes.grid(), points[i].position), 0, 0,
                                 hash(hash(samplers[i].key, samplers[i].index), kChoice)});
    while (!searches_.empty()) {
        rays_.clear();
        tried_.clear();
        for (Search& s : searches_) {
            const ShadingPoint& point = points[s.point];
            s.corner = draw_corner(s.cube, s.passed_over, random(s.key, s.passed_over));
            if (s.corner < 0) {
                own_.push_back(make_light_probe(scene, prepared, plan, probes.igloo(), point.position, point.excluded,
                                                s.key, options.isa));
                probe_[s.point] = &own_.back();
                continue;
            }
            rays_.add(point.position, s.cube.corner(s.corner) - point.position, 1, Excluded{});
            tried_.push_back(s);
        }
        occluded_.assign(rays_.size(), 0);
        if (!prepared.mesh.empty()) occluded_triangle(prepared.mesh, rays_.for_mesh(), occluded_, options.isa);
        searches_.clear();
        for (size_t ray = 0; ray < tried_.size(); ++ray) {
            Search& s = tried_[ray];
            if (occluded_[ray]) {
                s.passed_over |= 1u << s.corner;
                searches_.push_back(s);
                continue;
            }
            probe_[s.point] = &probes.at(s.cube.key(s.corner), [&](uint64_t) {
                return make_at_corner(scene, prepared, plan, options, s.cube, s.corner);
            });
        }
    }
}

}  // namespace tress
