// SPDX-License-Identifier: MIT
#include "core/light_sample.h"

#include <algorithm>
#include <glm/trigonometric.hpp>
#include <limits>

namespace tress {
namespace {

Rgb bounded(const glm::dvec3& irradiance) {
    return Rgb(clamp(irradiance, glm::dvec3(0), glm::dvec3(kLargestIrradiance)));
}

/// A density as float: of a speck of light it may be large, but is finite.
float narrow(double pdf) { return float(std::min(pdf, double(std::numeric_limits<float>::max()))); }

/// Direction and distance, in double: lights may be near enough or far enough for float to lose them.
struct Towards {
    DVec3 direction{0, 0, 1};
    double distance = 0;
};
Towards towards(const DVec3& light, const Vec3& point) {
    const DVec3 v = light - DVec3(point);
    const double largest = glm::max(glm::max(std::abs(v.x), std::abs(v.y)), std::abs(v.z));
    if (largest == 0) return {};
    const double distance = largest * length(v / largest);
    return {v / distance, distance};
}

}  // namespace

double spot_falloff(const SpotLight& light, const DVec3& from_light) {
    constexpr double soft = 0.9;
    const DVec3 axis = light.to - light.position;
    const double half = 0.5 * glm::radians(light.angle);
    const double angle = std::acos(glm::clamp(dot(from_light, axis) / length(axis), -1.0, 1.0));
    return 1 - glm::smoothstep(soft * half, half, angle);
}

LightSample sample(const PointLight& light, const Vec3& point, const Vec2&) {
    const Towards to = towards(light.position, point);
    if (to.distance == 0) return {};
    return {Vec3(to.direction), float(to.distance), bounded(glm::dvec3(light.intensity) / square(to.distance)), 0};
}

LightSample sample(const SpotLight& light, const Vec3& point, const Vec2& u) {
    LightSample s = sample(PointLight{light.position, light.intensity}, point, u);
    s.irradiance *= float(spot_falloff(light, -DVec3(s.direction)));
    return s;
}

LightSample sample(const DistantLight& light, const Vec3&, const Vec2&) {
    return {Vec3(-normalize(light.direction)), kInfinity, bounded(glm::dvec3(light.irradiance)), 0};
}

LightSample sample(const QuadLight& light, const Vec3& point, const Vec2& u) {
    const Towards to = towards(light.corner + double(u.x) * light.edge[0] + double(u.y) * light.edge[1], point);
    const DVec3 area_normal = cross(light.edge[0], light.edge[1]);  // its length is the area
    const double projected = -dot(to.direction, area_normal);
    if (to.distance == 0 || projected <= 0) return {};
    return {Vec3(to.direction), float(to.distance),
            bounded(glm::dvec3(light.radiance) * (projected / square(to.distance))),
            narrow(square(to.distance) / projected)};
}

LampHit hit(const QuadLight& light, const Vec3& origin, const Vec3& direction) {
    const DVec3 area_normal = cross(light.edge[0], light.edge[1]);
    const DVec3 d(direction), from_corner = DVec3(origin) - light.corner;
    const double projected = -dot(d, area_normal);
    const double distance = dot(from_corner, area_normal) / projected;
    if (!(projected > 0 && distance > 0)) return {};
    const DVec3 p = from_corner + distance * d;
    const double area_squared = dot(area_normal, area_normal);
    const double u = dot(cross(p, light.edge[1]), area_normal) / area_squared;
    const double v = dot(cross(light.edge[0], p), area_normal) / area_squared;
    if (!(u >= 0 && u <= 1 && v >= 0 && v <= 1)) return {};
    return {float(distance), light.radiance, narrow(square(distance) / projected)};
}

}  // namespace tress
