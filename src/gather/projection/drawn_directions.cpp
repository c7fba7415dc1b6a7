// SPDX-License-Identifier: MIT
#include "gather/projection/drawn_directions.h"

#include "gather/connection.h"

namespace tress {
namespace {

constexpr uint32_t kScatteringDimension = 0, kSkyDimension = kSobolGroup;

/// The sky that is sampled by brightness; null: none has a picture.
const EnvironmentSampler* bright_sky(const PreparedScene& prepared, const Plan& plan) {
    const EnvironmentSampler* sky = nullptr;
    for (const uint32_t light : plan.environments)
        if (!prepared.environment[light]->image.empty()) sky = &*prepared.environment[light];
    return sky;
}

Rgb sky_radiance(const PreparedScene& prepared, const Plan& plan, const Vec3& direction) {
    Rgb sum(0);
    for (const uint32_t light : plan.environments) sum += radiance(*prepared.environment[light], direction);
    return sum;
}

void add(const Vec3& direction, const Rgb& weight, const Rgb& from_sky, std::vector<DrawnDirection>& to) {
    if (!is_finite(weight) || !is_finite(from_sky)) return;
    if (max_component(weight) > 0 || max_component(from_sky) > 0) to.push_back({direction, weight, bounded(from_sky)});
}

}  // namespace

void DirectionDraw::operator()(const Scene& scene, const PreparedScene& prepared, const Plan& plan,
                               const ShadingPoint& point, const Sampler& sampler, int directions,
                               std::vector<DrawnDirection>& to) {
    const EnvironmentSampler* sky = bright_sky(prepared, plan);
    const uint32_t by_scattering = uint32_t(directions), by_sky = sky ? (by_scattering + 1) / 2 : 0;
    u_.clear();
    for (uint32_t j = 0; j < by_scattering; ++j)
        u_.push_back(Sampler{sampler.key, sampler.index * by_scattering + j}.get4(kScatteringDimension));
    drawn_.resize(by_scattering);
    draw_scattering(scene, point, u_, drawn_);
    to.clear();
    for (const ScatteredDirection& drawn : drawn_) {
        const float density = float(by_scattering) * drawn.scattering.pdf;
        const Rgb weight = drawn.scattering.value() / density;
        const float of_sky = sky ? float(by_sky) * pdf_environment(*sky, drawn.direction) : 0;
        add(drawn.direction, weight,
            weight * sky_radiance(prepared, plan, drawn.direction) * (density / (density + of_sky)), to);
    }
    for (uint32_t j = 0; j < by_sky; ++j) {
        const Sampler own{sampler.key, sampler.index * by_sky + j};
        const EnvironmentSample bright = sample_environment(*sky, own.get2(kSkyDimension));
        if (!(bright.pdf > 0)) continue;
        const Scattering scattered = scatter(scene, point, bright.direction);
        const float density = float(by_sky) * bright.pdf + float(by_scattering) * scattered.pdf;
        add(bright.direction, Rgb(0), scattered.value() * sky_radiance(prepared, plan, bright.direction) / density, to);
    }
}

}  // namespace tress
