// SPDX-License-Identifier: MIT
#include "gather/direct_light.h"

#include "core/light_sample.h"

namespace tress {
namespace {

/// A way from a point to a light, and the light that it would bring to the eye with nothing between.
struct Connection {
    Vec3 direction{0, 0, 1};
    float distance = 0;
    Rgb radiance{0};
};

/// Kept finite: two factors near the largest floats may overflow.
Rgb bounded(const Rgb& radiance) { return min(radiance, Rgb(kLargestIrradiance)); }

struct Connect {
    const Scene& scene;
    const PreparedScene& prepared;
    const ShadingPoint& point;
    const Sampler& sampler;
    uint32_t light;

    uint32_t dimension() const { return kFirstLightDimension + kDimensionsALight * light; }

    /// A lamp may lie in a polygon's plane, as in a ceiling: the ray stops short of it by the rounding of both ends.
    float short_of(float distance) const {
        if (std::isinf(distance)) return distance;
        constexpr float ulps = 32 * std::numeric_limits<float>::epsilon();
        return glm::max(distance - ulps * (max_component(abs(point.position)) + distance), 0.0f);
    }

    template <class Lamp>
    Connection operator()(const Lamp& lamp) const {
        const LightSample to = sample(lamp, point.position, sampler.get2(dimension()));
        if (!(max_component(to.irradiance) > 0)) return {};
        return {to.direction, short_of(to.distance),
                bounded(scatter(scene, point, to.direction).value * to.irradiance)};
    }

    /// Half of the directions follow the sky's brightness, half the scattering: the balance heuristic with one sample
    /// (Veach 1997, sec. 9.2.4), which keeps sharp lobes and small suns alike from becoming noise.
    Connection operator()(const EnvironmentLight&) const {
        const EnvironmentSampler& sky = *prepared.environment[light];
        const glm::vec4 u = sampler.get4(dimension());
        const bool by_sky = sampler.get(dimension() + kSobolGroup) < 0.5f;
        const Vec3 direction =
            by_sky ? sample_environment(sky, {u.x, u.y}).direction : sample_scattering(scene, point, u);
        const Scattering scattered = scatter(scene, point, direction);
        const float pdf = 0.5f * (pdf_environment(sky, direction) + scattered.pdf);
        if (!(pdf > 0 && max_component(scattered.value) > 0)) return {};
        return {direction, kInfinity, bounded(scattered.value * (radiance(sky, direction) / pdf))};
    }
};

}  // namespace

void DirectLight::operator()(const Scene& scene, const PreparedScene& prepared, const Options& options,
                             std::span<const uint32_t> lights, std::span<const ShadingPoint> points,
                             std::span<const Sampler> samplers, std::span<Rgb> radiance) {
    for (const uint32_t light : lights) {
        rays_.clear();
        point_of_ray_.clear();
        unshadowed_.clear();
        for (uint32_t i = 0; i < points.size(); ++i) {
            const Connection to =
                std::visit(Connect{scene, prepared, points[i], samplers[i], light}, scene.lights[light]);
            if (!(max_component(to.radiance) > 0)) continue;
            rays_.add(points[i].position, to.direction, to.distance, points[i].excluded);
            point_of_ray_.push_back(i);
            unshadowed_.push_back(to.radiance);
        }
        visibility_.resize(rays_.size());
        query_(prepared, rays_, options, visibility_);
        for (size_t ray = 0; ray < rays_.size(); ++ray)
            radiance[point_of_ray_[ray]] += unshadowed_[ray] * visibility_[ray];
    }
}

}  // namespace tress
