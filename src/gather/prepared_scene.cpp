// SPDX-License-Identifier: MIT
#include "gather/prepared_scene.h"

#include <chrono>

#include "accel/build.h"
#include "gather/photons/photon_tracing.h"
#include "gather/projection/calibrate_gap.h"
#include "gather/shadow_maps/seen_hair.h"

namespace tress {
namespace {

/// Runs `build`, which returns the bytes it keeps, and books its cost.
template <class Build>
void timed(std::vector<StageCost>& costs, const char* name, const Build& build) {
    const auto start = std::chrono::steady_clock::now();
    const size_t bytes = build();
    costs.push_back({name, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), bytes});
}

template <class T>
size_t vector_bytes(const std::vector<T>& v) {
    return v.capacity() * sizeof(T);
}

size_t make_attenuation(const Scene& scene, const Plan& plan, Attenuation& to) {
    size_t bytes = 0;
    for (const Fiber& fiber : scene.fibers) {
        if (plan.hair_colors) {
            to.varying.push_back(make_absorption_table(fiber));
            bytes += vector_bytes(to.varying.back().depth);
        } else {
            to.table.push_back(make_attenuation_table(fiber));
            bytes += vector_bytes(to.table.back().depth);
        }
    }
    if (scene.fibers.size() > 1)
        for (uint16_t fiber = 0; fiber < scene.fibers.size(); ++fiber)
            to.fiber_of_segment.insert(to.fiber_of_segment.end(),
                                       scene.fiber_segment[fiber + 1u] - scene.fiber_segment[fiber], fiber);
    return bytes + vector_bytes(to.fiber_of_segment);
}

size_t make_hair_colors(const Scene& scene, const SegmentView& segments, Attenuation& to) {
    to.sigma_a.reserve(segments.size());
    for (const uint32_t point : segments.point) to.sigma_a.push_back(scene.sigma_a[point]);
    return vector_bytes(to.sigma_a) + vector_bytes(scene.sigma_a);
}

size_t make_environments(const Scene& scene, const Plan& plan, std::vector<std::optional<EnvironmentSampler>>& to) {
    size_t total = 0;
    for (const uint32_t light : plan.environments) {
        to[light] = make_environment_sampler(std::get<EnvironmentLight>(scene.lights[light]));
        total += bytes(*to[light]);
    }
    return total;
}

void make_maps(const Scene& scene, const Plan& plan, const Options& options, const TracedPhotons& traced,
               PreparedScene& p) {
    if (plan.polygon_gather)
        timed(p.costs, stage::kPhotonMap, [&] {
            p.photons.irradiance = make_irradiance_map(traced.on_polygons, scene.mesh, p.mesh, options);
            return bytes(p.photons.irradiance);
        });
    if (any(plan.photon_display))
        timed(p.costs, stage::kShownPhotons, [&] {
            p.photons.shown = make_shown_photons(traced.in_hair, traced.on_polygons, plan.photon_display, p.segments,
                                                 options.photons);
            return bytes(p.photons.shown);
        });
}

void make_shadow_maps(const Scene& scene, const Plan& plan, const Options& options, PreparedScene& p) {
    SeenHair seen;
    for (int kind = 0; kind < kMapKinds; ++kind) {
        if (!plan.shadow_maps(MapKind(kind))) continue;
        timed(p.costs, stage::kShadowMaps[kind], [&] {
            if (seen.bounds.empty()) seen = find_seen_hair(scene, p, options);
            LampMaps& maps = p.shadow_maps[size_t(kind)];
            maps = make_lamp_maps(scene.lights, plan.lamps, MapKind(kind), p.segments, seen, p.attenuation, options);
            return bytes(maps);
        });
    }
}

}  // namespace

PreparedScene prepare(const Scene& scene, const Plan& plan, const Options& options) {
    PreparedScene p;
    p.segments = view(scene.hair, scene.segments);
    p.environment.resize(scene.lights.size());
    if (plan.hair_tree)
        timed(p.costs, stage::kHairTree, [&] {
            p.hair = build_segment_tree(p.segments, options.accel);
            return bytes(p.hair);
        });
    if (plan.mesh_tree)
        timed(p.costs, stage::kMeshTree, [&] {
            p.mesh = build_triangle_tree(scene.mesh, options.accel);
            return bytes(p.mesh);
        });
    if (!plan.environments.empty())
        timed(p.costs, stage::kEnvironment, [&] { return make_environments(scene, plan, p.environment); });
    if (plan.attenuation)
        timed(p.costs, stage::kAttenuation, [&] { return make_attenuation(scene, plan, p.attenuation); });
    if (plan.hair_colors)
        timed(p.costs, stage::kHairColors, [&] { return make_hair_colors(scene, p.segments, p.attenuation); });
    make_shadow_maps(scene, plan, options, p);
    if (plan.photons()) {
        TracedPhotons traced;
        timed(p.costs, stage::kPhotons, [&] {
            traced = trace_photons(scene, p, plan, options);
            return bytes(traced.on_polygons) + bytes(traced.in_hair);
        });
        p.photon_statistics = std::move(traced.statistics);
        make_maps(scene, plan, options, traced, p);
    }
    if (plan.projection)
        timed(p.costs, stage::kProjectedHair, [&] {
            p.projection = make_hair_projection(p.segments, p.attenuation, *plan.projection, options);
            if (plan.mesh_tree || plan.far_field)
                p.probes = std::make_unique<LightProbes>(p.projection.bounds, options.projection, plan.far_field);
            calibrate_gap(p, options, make_light_trials(scene, plan, p, options));
            return bytes(p.projection);
        });
    return p;
}

}  // namespace tress
