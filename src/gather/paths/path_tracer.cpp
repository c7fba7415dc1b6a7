// SPDX-License-Identifier: MIT
#include "gather/paths/path_tracer.h"

#include <cmath>

#include "gather/connection.h"
#include "gather/streams.h"

namespace tress {
namespace {

constexpr uint32_t kFreeVertices = 4;   // before roulette: most light has come by then
constexpr uint32_t kManyVertices = 32;  // from here on every path may end, in white rooms too
constexpr float kLargestChance = 0.95f;

float chance_to_live(const PathWalk& walk, const Throughput& throughput) {
    if (walk.vertices < kFreeVertices) return 1;
    return glm::min(max_component(throughput.sum()), walk.vertices < kManyVertices ? 1 : kLargestChance);
}

/// The vertex where a ray ends at a fiber. Straight model: it is an event R. Full model: what kind of event it is, is
/// settled by where it scatters light from.
PathWalk at_fiber(const PathContext& context, const PathWalk& from, const Vec3& direction, const Hit& hit) {
    PathWalk to{from.start, from.sampler, from.vertices + 1,
                fiber_point(context.scene, context.prepared, direction, hit)};
    to.is_event = context.options.scattering == ScatteringModel::full;
    if (!to.is_event) to.point.lobes = FiberLobes::reflected;
    return to;
}

PathWalk at_polygon(const PathContext& context, const PathWalk& from, const Vec3& direction, const Hit& hit) {
    return {from.start, from.sampler, from.vertices + 1, polygon_point(context.scene, direction, hit)};
}

}  // namespace

void PathTracer::operator()(const Scene& scene, const PreparedScene& prepared, const Plan& plan, const Options& options,
                            std::span<const ShadingPoint> points, std::span<const Sampler> samplers,
                            std::span<LightByType> light) {
    const PathContext context{scene, prepared, plan, options, path_goals(scene, plan, options)};
    walks_.clear();
    for (uint32_t i = 0; i < points.size(); ++i)
        walks_.push_back({i, stream_of(samplers[i], Stream::paths), 0, points[i]});
    while (!walks_.empty()) {
        lights_(context, walks_, light);
        depart(context);
        book_lights(context, light);
        arrive(context);
        std::swap(walks_, next_);
    }
}

void PathTracer::depart(const PathContext& context) {
    departures_.clear();
    chances_.clear();
    rays_.rays.clear();
    for (uint32_t i = 0; i < walks_.size(); ++i) {
        const PathWalk& walk = walks_[i];
        const glm::vec4 u = walk.sampler.get4(dimension_of(context, walk, PathNumber::scattering));
        const Vec3 direction = sample_scattering(context.scene, walk.point, u);
        const Scattering scattering = scatter(context.scene, walk.point, direction);
        if (!std::isnormal(scattering.pdf)) continue;  // its inverse is finite
        Throughput throughput = still_wanted(context.goals, past_vertex(walk, scattering) * Rgb(1 / scattering.pdf));
        if (!goes_on(context.goals, throughput)) continue;

        const uint32_t numbers = dimension_of(context, walk, PathNumber::choices);
        const float lives = chance_to_live(walk, throughput);
        if (!(walk.sampler.get(numbers + kRouletteNumber) < lives)) continue;
        throughput *= Rgb(1 / lives);
        rays_.rays.add(walk.point.position, direction, kInfinity, walk.point.excluded);
        chances_.push_back(1 - walk.sampler.get(numbers + kFlightNumber));
        departures_.push_back({i, scattering.pdf, throughput});
    }
    rays_.trace(context.prepared, context.options, chances_);
}

void PathTracer::book_lights(const PathContext& context, std::span<LightByType> light) const {
    const auto add = [&](const Departure& from, LightSource source, const Rgb& radiance, float pdf_of_light,
                         const Rgb& weight) {
        const Rgb brought = bounded(radiance * weight * balance(from.pdf, pdf_of_light));
        book(context.goals, from.throughput, source, brought, light[walks_[from.walk].start]);
    };
    for (size_t ray = 0; ray < departures_.size(); ++ray) {
        const Departure& from = departures_[ray];
        const Vec3 origin = rays_.rays.origin(ray), direction = rays_.rays.direction(ray);
        for (const uint32_t lamp : context.plan.lamps) {
            const auto* quad = std::get_if<QuadLight>(&context.scene.lights[lamp]);
            if (!quad) continue;
            const LampHit at = hit(*quad, origin, direction);
            if (std::isinf(at.distance)) continue;
            const Rgb weight = rays_.weight_at(ray, short_of(origin, at.distance));
            add(from, LightSource::lamp, at.radiance, at.pdf, weight);
        }
        if (rays_.end(ray) != PathEnd::nothing) continue;
        for (const uint32_t light_index : context.plan.environments) {
            const EnvironmentSampler& sky = *context.prepared.environment[light_index];
            add(from, LightSource::elsewhere, radiance(sky, direction), pdf_environment(sky, direction),
                rays_.weight(ray));
        }
    }
}

void PathTracer::arrive(const PathContext& context) {
    next_.clear();
    const bool straight = context.options.scattering == ScatteringModel::straight;
    for (size_t ray = 0; ray < departures_.size(); ++ray) {
        const PathEnd end = rays_.end(ray);
        if (end == PathEnd::nothing) continue;
        Throughput throughput = departures_[ray].throughput * rays_.weight(ray);
        if (end == PathEnd::polygon) throughput = settled(throughput);
        if (end == PathEnd::fiber && straight) throughput = reflected(throughput);
        throughput = still_wanted(context.goals, throughput);
        if (!(max_component(throughput.sum()) > 0)) continue;

        const PathWalk& from = walks_[departures_[ray].walk];
        const Vec3 direction = rays_.rays.direction(ray);
        const Hit hit = rays_.hit(ray);
        next_.push_back(end == PathEnd::fiber ? at_fiber(context, from, direction, hit)
                                              : at_polygon(context, from, direction, hit));
        next_.back().throughput = throughput;
    }
}

}  // namespace tress
