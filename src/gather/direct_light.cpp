// SPDX-License-Identifier: MIT
#include "gather/direct_light.h"

namespace tress {

void DirectLight::operator()(const Scene& scene, const PreparedScene& prepared, const Options& options,
                             std::span<const uint32_t> lights, const LampMaps* maps,
                             std::span<const ShadingPoint> points, std::span<const Sampler> samplers,
                             std::span<Rgb> radiance) {
    for (const uint32_t light : lights) {
        const uint32_t rays = prepared.environment[light] ? uint32_t(options.gather.rays) : 1;
        make_light_rays(scene, prepared, light, rays, points, samplers, rays_);
        visibility_.resize(rays_.size());
        query_(scene, prepared, maps, options.maps.near, options, rays_.to, visibility_);
        for (size_t ray = 0; ray < rays_.size(); ++ray)
            radiance[rays_.point[ray]] += rays_.unshadowed[ray] * visibility_[ray];
    }
}

}  // namespace tress
