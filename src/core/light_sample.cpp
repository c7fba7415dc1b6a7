// SPDX-License-Identifier: MIT
#include "core/light_sample.h"

#include <algorithm>
#include <glm/trigonometric.hpp>
#include <limits>
#include <numbers>

#include "core/spherical_triangle.h"

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

/// Whether samples of a lamp are uniform over its solid angle, not its area.
bool is_near(const QuadLight& light, const Vec3& point) {
    const DVec3 &a = light.edge[0], &b = light.edge[1];
    const DVec3 to_middle = light.corner + 0.5 * (a + b) - DVec3(point);
    return dot(to_middle, to_middle) < glm::max(dot(a + b, a + b), dot(a - b, a - b));
}

/// Where a ray meets the plane of a lamp on the side that shines.
struct Meeting {
    double distance = 0, projected = 0;  // projected: area of the lamp, seen along the ray
    glm::dvec2 place{-1};                // in shares of the edges; outside [0, 1]: beside the lamp, or nowhere
};
Meeting meet(const QuadLight& light, const Vec3& origin, const DVec3& direction) {
    const DVec3 area_normal = cross(light.edge[0], light.edge[1]);  // its length is the area
    const DVec3 from_corner = DVec3(origin) - light.corner;
    const double projected = -dot(direction, area_normal);
    const double distance = dot(from_corner, area_normal) / projected;
    if (!(projected > 0 && distance > 0)) return {};
    const DVec3 p = from_corner + distance * direction;
    const double area_squared = dot(area_normal, area_normal);
    const glm::dvec2 place(dot(cross(p, light.edge[1]), area_normal) / area_squared,
                           dot(cross(light.edge[0], p), area_normal) / area_squared);
    if (!std::isfinite(place.x + place.y)) return {};  // of a speck: its area underflows
    return {distance, projected, place};
}

/// A quad as two spherical triangles about a point, which share its first corner and the diagonal from there.
class NearQuad {
public:
    NearQuad(const QuadLight& light, const Vec3& point) {
        const DVec3 &a = light.edge[0], &b = light.edge[1];
        const Towards corner[4] = {towards(light.corner, point), towards(light.corner + a, point),
                                   towards(light.corner + (a + b), point), towards(light.corner + b, point)};
        // Six times the volume between the point and half the lamp: the height of the point times the lamp's area.
        const double volume = dot(DVec3(point) - light.corner, cross(a, b)) / corner[0].distance / corner[2].distance;
        for (int i = 0; i < 2; ++i) {
            const Towards &from = corner[1 + i], &to = corner[2 + i];
            half_[i] = {corner[0].direction, from.direction, to.direction, volume / corner[1 + 2 * i].distance};
            // Not of points behind the lamp, in its plane or at a corner.
            part_[i] = half_[i].volume > 0 && std::isfinite(half_[i].volume) ? solid_angle(half_[i]) : 0;
        }
        // From a point on the diagonal both halves may round to hemispheres: the lamp is in one all the same.
        const double excess = size() / (2 * std::numbers::pi);
        if (excess > 1)
            for (double& part : part_) part /= excess;
    }

    double size() const { return part_[0] + part_[1]; }  // solid angle
    double pdf() const { return size() > 0 ? 1 / size() : 0; }
    DVec3 direction(const glm::dvec2& u) const {
        const double part = u.x * size();
        return part < part_[0] ? direction_in(half_[0], part, u.y) : direction_in(half_[1], part - part_[0], u.y);
    }

private:
    SphericalTriangle half_[2];
    double part_[2];
};

LightSample sample_far(const QuadLight& light, const Vec3& point, const Vec2& u) {
    const Towards to = towards(light.corner + double(u.x) * light.edge[0] + double(u.y) * light.edge[1], point);
    const DVec3 area_normal = cross(light.edge[0], light.edge[1]);
    const double projected = -dot(to.direction, area_normal);
    if (to.distance == 0 || projected <= 0) return {};
    return {Vec3(to.direction), float(to.distance),
            bounded(glm::dvec3(light.radiance) * (projected / square(to.distance))),
            narrow(square(to.distance) / projected), u};
}

LightSample sample_near(const QuadLight& light, const Vec3& point, const Vec2& u) {
    const NearQuad quad(light, point);
    if (!(quad.size() > 0)) return {};
    Towards to{quad.direction(u), 0};
    const Meeting met = meet(light, point, to.direction);
    if (!(met.distance > 0)) return {};  // along the plane, by rounding
    to.distance = met.distance;
    const glm::dvec2 place = clamp(met.place, 0.0, 1.0);
    if (place != met.place) to = towards(light.corner + place.x * light.edge[0] + place.y * light.edge[1], point);
    return {Vec3(to.direction), float(to.distance), bounded(glm::dvec3(light.radiance) * quad.size()),
            narrow(quad.pdf()), Vec2(place)};
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
    return is_near(light, point) ? sample_near(light, point, u) : sample_far(light, point, u);
}

LampHit hit(const QuadLight& light, const Vec3& origin, const Vec3& direction) {
    const Meeting met = meet(light, origin, DVec3(direction));
    if (!(met.place == clamp(met.place, 0.0, 1.0))) return {};
    const double pdf = is_near(light, origin) ? NearQuad(light, origin).pdf() : square(met.distance) / met.projected;
    return {float(met.distance), light.radiance, narrow(pdf)};
}

}  // namespace tress
