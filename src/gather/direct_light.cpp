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
    static constexpr uint32_t kPairs = 4;  // more cost more than the noise that they take away

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
                bounded(scatter(scene, point, to.direction).value() * to.irradiance)};
    }

    /// Of kPairs directions by the sky's brightness and kPairs by the scattering (balance heuristic: Veach 1997, ch.
    /// 9), one is kept in proportion to the light it brings, and only that one is traced: resampled importance sampling
    /// (Talbot et al. 2005). Sharp lobes and small suns alike leave little noise but that of the shadows.
    Connection operator()(const EnvironmentLight&) const {
        const EnvironmentSampler& sky = *prepared.environment[light];
        Rgb color(0);  // of the light of the direction kept, at luminance 1
        Vec3 kept(0);
        float sum = 0, u = sampler.get(dimension() + 2 * kSobolGroup);
        const auto offer = [&](const Vec3& direction) {
            const Scattering scattered = scatter(scene, point, direction);
            const float pdf = 0.5f * (pdf_environment(sky, direction) + scattered.pdf);
            const Rgb brought = bounded(scattered.value() * radiance(sky, direction));
            const float weight = luminance(brought) / pdf;
            if (!(pdf > 0 && weight > 0)) return;
            sum += weight;
            const float chance = weight / sum;
            if (u < chance) {
                kept = direction;
                color = brought / luminance(brought);
                u /= chance;
            } else {
                u = (u - chance) / (1 - chance);
            }
        };
        for (uint32_t pair = 0; pair < kPairs; ++pair) {
            const Sampler own{sampler.key, sampler.index * kPairs + pair};
            offer(sample_environment(sky, own.get2(dimension())).direction);
            offer(sample_scattering(scene, point, own.get4(dimension() + kSobolGroup)));
        }
        return {kept, kInfinity, bounded(color * (sum / (2 * kPairs)))};
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
