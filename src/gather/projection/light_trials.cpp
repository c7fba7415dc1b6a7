// SPDX-License-Identifier: MIT
#include "gather/projection/light_trials.h"

#include <tbb/parallel_for.h>

#include "core/rng.h"
#include "gather/projection/make_light_probe.h"
#include "gather/projection/probes_of_points.h"
#include "gather/seen_points.h"

namespace tress {
namespace {

constexpr size_t kPoints = 256;
constexpr int kDirections = 512;  // a point
constexpr uint64_t kKey = hash(0, 0x747269616c);

}  // namespace

std::vector<LightTrial> make_light_trials(const Scene& scene, const Plan& plan, const PreparedScene& prepared,
                                          const Options& options) {
    const std::vector<ShadingPoint> seen = find_seen_points(scene, prepared, options);
    std::vector<LightTrial> trials(std::min(seen.size(), kPoints));
    tbb::parallel_for(size_t(0), trials.size(), [&](size_t i) {
        LightTrial& t = trials[i];
        t.point = seen[i * seen.size() / trials.size()];
        const Sampler sampler{hash(kKey, i), 0};
        std::vector<DrawnDirection> directions;
        DirectionDraw()(scene, prepared, plan, t.point, sampler, kDirections, directions);
        if (plan.far_field) {
            ProbesOfPoints probes;
            probes.find(scene, prepared, plan, options, {&t.point, 1}, {&sampler, 1});
            t.probe = probes.of(0);
        } else if (prepared.probes) {
            t.probe = make_light_probe(scene, prepared, plan, prepared.probes->igloo(), t.point.position,
                                       t.point.excluded, hash(kKey, i), options.isa);
        }
        if (t.probe && !t.probe->cells.empty())
            find_seen_light(*t.probe, prepared.probes->igloo(), t.point, directions, t.seen);
        else
            SeenLightByRays()(scene, prepared, plan, options, t.point, directions, t.seen);
    });
    return trials;
}

}  // namespace tress
