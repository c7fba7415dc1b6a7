// SPDX-License-Identifier: MIT
#include "gather/direct_light.h"

#include "core/light_sample.h"

namespace tress {
namespace {

LightSample sample_light(const Scene& scene, const PreparedScene& prepared, uint32_t light, const Vec3& position,
                         const Vec2& u) {
    return std::visit(
        [&](const auto& kind) -> LightSample {
            if constexpr (std::is_same_v<std::decay_t<decltype(kind)>, EnvironmentLight>) {
                const EnvironmentSample s = sample_environment(*prepared.environment[light], u);
                if (!(s.pdf > 0)) return {};
                return {s.direction, kInfinity, min(s.radiance / s.pdf, Rgb(kLargestIrradiance))};
            } else {
                return sample(kind, position, u);
            }
        },
        scene.lights[light]);
}

/// f |cos| E, kept finite: two factors near the largest floats may overflow.
Rgb bounded_product(const Rgb& scattered, const Rgb& irradiance) {
    return min(scattered * irradiance, Rgb(kLargestIrradiance));
}

}  // namespace

void DirectLight::operator()(const Scene& scene, const PreparedScene& prepared, const Options& options,
                             std::span<const uint32_t> lights, std::span<const ShadingPoint> points,
                             std::span<const Sampler> samplers, std::span<Rgb> radiance) {
    for (const uint32_t light : lights) {
        rays_.clear();
        point_of_ray_.clear();
        unshadowed_.clear();
        const uint32_t dimension = kFirstLightDimension + kDimensionsALight * light;
        for (uint32_t i = 0; i < points.size(); ++i) {
            const ShadingPoint& point = points[i];
            const LightSample to = sample_light(scene, prepared, light, point.position, samplers[i].get2(dimension));
            if (max_component(to.irradiance) <= 0) continue;
            const Rgb scattered = scatter(scene, point, to.direction);
            if (max_component(scattered) <= 0) continue;
            rays_.add(point.position, to.direction, to.distance, point.excluded);
            point_of_ray_.push_back(i);
            unshadowed_.push_back(bounded_product(scattered, to.irradiance));
        }
        visibility_.resize(rays_.size());
        query_(prepared, rays_, options, visibility_);
        for (size_t ray = 0; ray < rays_.size(); ++ray)
            radiance[point_of_ray_[ray]] += unshadowed_[ray] * visibility_[ray];
    }
}

}  // namespace tress
