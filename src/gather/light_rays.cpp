// SPDX-License-Identifier: MIT
#include "gather/light_rays.h"

#include "gather/connection.h"
#include "gather/reservoir.h"

namespace tress {
namespace {

constexpr uint32_t kPairs = 4;  // more cost more than the noise that they take away

uint32_t dimension_of(uint32_t light) { return kFirstLightDimension + kDimensionsALight * light; }

/// Of kPairs directions by the sky's brightness and kPairs by the scattering (balance heuristic: Veach 1997, ch. 9),
/// one is kept in proportion to the light it brings, and only that one is traced: resampled importance sampling
/// (Talbot et al. 2005). Sharp lobes and small suns alike leave little noise but that of the shadows.
Connection connect_sky(const Scene& scene, const ShadingPoint& point, const EnvironmentSampler& sky,
                       const Sampler& sampler, uint32_t dimension) {
    Rgb color(0);  // of the light of the direction kept, at luminance 1
    Vec3 kept(0);
    Reservoir reservoir(sampler.get(dimension + 2 * kSobolGroup));
    const auto offer = [&](const Vec3& direction) {
        const Scattering scattered = scatter(scene, point, direction);
        const float pdf = 0.5f * (pdf_environment(sky, direction) + scattered.pdf);
        const Rgb brought = bounded(scattered.value() * radiance(sky, direction));
        const float weight = luminance(brought) / pdf;
        if (!(pdf > 0 && weight > 0) || !reservoir.offer(weight)) return;
        kept = direction;
        color = brought / luminance(brought);
    };
    for (uint32_t pair = 0; pair < kPairs; ++pair) {
        const Sampler own{sampler.key, sampler.index * kPairs + pair};
        offer(sample_environment(sky, own.get2(dimension)).direction);
        offer(sample_scattering(scene, point, own.get4(dimension + kSobolGroup)));
    }
    return {kept, kInfinity, bounded(color * (reservoir.sum() / (2 * kPairs))), {}};
}

Connection connect(const Scene& scene, const PreparedScene& prepared, const ShadingPoint& point, const Sampler& sampler,
                   uint32_t light) {
    if (const auto& sky = prepared.environment[light])
        return connect_sky(scene, point, *sky, sampler, dimension_of(light));
    return connect_lamp(scene, point, scene.lights[light], sampler.get2(dimension_of(light)));
}

}  // namespace

void make_light_rays(const Scene& scene, const PreparedScene& prepared, uint32_t light, uint32_t rays,
                     std::span<const ShadingPoint> points, std::span<const Sampler> samplers, LightRays& made) {
    made.to.clear();
    made.point.clear();
    made.unshadowed.clear();
    for (uint32_t i = 0; i < points.size() * rays; ++i) {
        const ShadingPoint& point = points[i / rays];
        const Sampler sampler{samplers[i / rays].key, samplers[i / rays].index * rays + i % rays};
        const Connection to = connect(scene, prepared, point, sampler, light);
        if (!(max_component(to.radiance) > 0)) continue;
        made.to.add(point.position, to.direction, to.distance, point.excluded, light, to.place, point.segment);
        made.point.push_back(i / rays);
        made.unshadowed.push_back(to.radiance / float(rays));
    }
}

}  // namespace tress
