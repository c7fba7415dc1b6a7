// SPDX-License-Identifier: MIT
#include "gather/connection.h"

namespace tress {
namespace {

struct SampleLamp {
    const Vec3& point;
    const Vec2& u;

    template <class Lamp>
    LightSample operator()(const Lamp& lamp) const {
        return sample(lamp, point, u);
    }
    LightSample operator()(const EnvironmentLight&) const { return {}; }
};

}  // namespace

float short_of(const Vec3& point, float distance) {
    if (std::isinf(distance)) return distance;
    constexpr float ulps = 32 * std::numeric_limits<float>::epsilon();
    return glm::max(distance - ulps * (max_component(abs(point)) + distance), 0.0f);
}

LightSample sample_lamp(const Light& light, const Vec3& point, const Vec2& u) {
    return std::visit(SampleLamp{point, u}, light);
}

LightSample sample_light(const Scene& scene, const PreparedScene& prepared, uint32_t light, const Vec3& origin,
                         const Vec2& u) {
    if (prepared.environment[light]) {
        const EnvironmentSample sky = sample_environment(*prepared.environment[light], u);
        if (!(sky.pdf > 0)) return {};
        return {sky.direction, kInfinity, bounded(sky.radiance / sky.pdf), sky.pdf};
    }
    LightSample to = sample_lamp(scene.lights[light], origin, u);
    to.distance = short_of(origin, to.distance);
    return to;
}

Connection connect_lamp(const Scene& scene, const ShadingPoint& point, const Light& light, const Vec2& u) {
    const LightSample to = sample_lamp(light, point.position, u);
    if (!(max_component(to.irradiance) > 0)) return {};
    return {to.direction, short_of(point.position, to.distance),
            bounded(scatter(scene, point, to.direction).value() * to.irradiance), to.place};
}

}  // namespace tress
