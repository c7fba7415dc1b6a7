// SPDX-License-Identifier: MIT
#include "gather/projection/light_trials.h"

#include <tbb/parallel_for.h>

#include "core/rng.h"
#include "gather/projection/make_light_probe.h"
#include "gather/projection/probes_of_points.h"
#include "gather/seen_points.h"

namespace tress {
namespace {

constexpr int kDirections = 512;  // a point
constexpr uint64_t kKey = hash(0, 0x747269616c);

/// At most `most` of the points, evenly spread over their order; see(its sampler, its drawn directions, trial) says
/// what light they may receive.
template <class See>
std::vector<LightTrial> trials_at(const Scene& scene, const Plan& plan, const PreparedScene& prepared,
                                  const std::vector<ShadingPoint>& points, size_t most, const See& see) {
    std::vector<LightTrial> trials(std::min(points.size(), most));
    tbb::parallel_for(size_t(0), trials.size(), [&](size_t i) {
        LightTrial& t = trials[i];
        t.point = points[i * points.size() / trials.size()];
        const Sampler sampler{hash(kKey, i), 0};
        std::vector<DrawnDirection> directions;
        DirectionDraw()(scene, prepared, plan, t.point, sampler, kDirections, directions);
        see(sampler, directions, t);
    });
    return trials;
}

}  // namespace

LightTrials make_light_trials(const Scene& scene, const Plan& plan, const PreparedScene& prepared,
                              const Options& options) {
    using Directions = std::vector<DrawnDirection>;
    const auto by_rays = [&](const Directions& directions, LightTrial& t) {
        SeenLightByRays()(scene, prepared, plan, options, t.point, directions, t.seen);
    };
    const auto at_hair = [&](const Sampler& sampler, const Directions& directions, LightTrial& t) {
        if (plan.far_field) {
            ProbesOfPoints probes;
            probes.find(scene, prepared, plan, options, {&t.point, 1}, {&sampler, 1});
            t.probe = probes.of(0);
        } else if (prepared.probes) {
            t.probe = make_light_probe(scene, prepared, plan, prepared.probes->igloo(), t.point.position,
                                       t.point.excluded, sampler.key, options.isa);
        }
        if (t.probe && !t.probe->cells.empty())
            find_seen_light(*t.probe, prepared.probes->igloo(), t.point, directions, t.seen);
        else
            by_rays(directions, t);
    };
    const auto at_polygon = [&](const Sampler&, const Directions& directions, LightTrial& t) {
        by_rays(directions, t);
        std::erase_if(t.seen, [](const SeenLight& light) { return light.among_hair; });  // not through cells
    };
    SeenPoints seen = find_seen_points(scene, prepared, options);
    std::erase_if(seen.polygons, [&](const ShadingPoint& p) { return !prepared.projection.bounds.holds(p.position); });
    const size_t points = size_t(plan.gap_points);
    return {trials_at(scene, plan, prepared, seen.hair, points, at_hair),
            trials_at(scene, plan, prepared, seen.polygons, points / kGapPointsOfPolygons, at_polygon)};
}

}  // namespace tress
