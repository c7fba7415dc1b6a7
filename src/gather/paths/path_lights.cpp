// SPDX-License-Identifier: MIT
#include "gather/paths/path_lights.h"

#include "gather/connection.h"
#include "gather/reservoir.h"

namespace tress {
namespace {

/// The direction kept, and the light of each type that the eye would see by it with nothing between.
struct PathConnection {
    Vec3 direction{0, 0, 1};
    float distance = 0;
    LightByType light{};
    bool found = false;
};

class Connect {
public:
    Connect(const PathContext& context, const PathWalk& walk)
        : c_(context),
          walk_(walk),
          reservoir_(walk.sampler.get(dimension_of(c_, walk, PathNumber::choices) + kReservoirNumber)) {}

    PathConnection operator()() {
        const Throughput taken =
            walk_.is_event ? scattered(walk_.throughput, Rgb(1), Rgb(1)) : walk_.throughput;  // states, not amounts
        uint32_t number = 0;
        for (const LightSource source : {LightSource::lamp, LightSource::elsewhere}) {
            const auto& lights = source == LightSource::lamp ? c_.plan.lamps : c_.plan.environments;
            const bool wanted = takes(c_.goals, taken, source);
            for (const uint32_t light : lights) {
                if (wanted) offer(source, light, number);
                ++number;
            }
        }
        const float share = reservoir_.sum() / kept_luminance_;
        for (Rgb& of_type : kept_.light) of_type = bounded(of_type * share);
        return kept_;
    }

private:
    void offer(LightSource source, uint32_t light, uint32_t number) {
        const Vec2 u = walk_.sampler.get2(dimension_of(c_, walk_, PathNumber::light, number));
        const LightSample to = sample_light(c_.scene, c_.prepared, light, walk_.point.position, u);
        if (!(max_component(to.irradiance) > 0)) return;
        const Scattering scattering = scatter(c_.scene, walk_.point, to.direction);
        const float share = to.pdf > 0 ? balance(to.pdf, scattering.pdf) : 1;
        LightByType brought{};
        book(c_.goals, past_vertex(walk_, scattering), source, to.irradiance * share, brought);
        Rgb sum(0);
        for (Rgb& of_type : brought) sum += of_type = bounded(of_type);
        const float weight = luminance(sum);
        if (!(weight > 0) || !reservoir_.offer(weight)) return;
        kept_ = {to.direction, to.distance, brought, true};
        kept_luminance_ = weight;
    }

    const PathContext& c_;
    const PathWalk& walk_;
    Reservoir reservoir_;
    PathConnection kept_;
    float kept_luminance_ = 1;
};

}  // namespace

void PathLights::operator()(const PathContext& context, std::span<const PathWalk> walks, std::span<LightByType> light) {
    rays_.clear();
    start_of_ray_.clear();
    unshadowed_.clear();
    for (const PathWalk& walk : walks) {
        const PathConnection to = Connect(context, walk)();
        if (!to.found) continue;
        rays_.add(walk.point.position, to.direction, to.distance, walk.point.excluded);
        start_of_ray_.push_back(walk.start);
        unshadowed_.push_back(to.light);
    }
    visibility_.resize(rays_.size());
    query_(context.prepared, rays_, context.options, visibility_);
    for (size_t ray = 0; ray < rays_.size(); ++ray)
        for (size_t type = 0; type < size_t(kPathTypes); ++type)
            light[start_of_ray_[ray]][type] += unshadowed_[ray][type] * visibility_[ray];
}

}  // namespace tress
