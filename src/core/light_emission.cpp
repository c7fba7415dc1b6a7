// SPDX-License-Identifier: MIT
#include "core/light_emission.h"

#include <glm/trigonometric.hpp>
#include <numbers>
#include <optional>

#include "core/frame.h"
#include "core/light_sample.h"
#include "core/sampling.h"

namespace tress {
namespace {

constexpr double kPi64 = std::numbers::pi;

Rgb bounded(const DVec3& power) { return Rgb(clamp(power, DVec3(0), DVec3(double(kLargestPower)))); }

bool is_light(const Rgb& power) { return max_component(power) > 0; }

/// Length that neither overflows nor vanishes.
double safe_length(const DVec3& v) {
    const double largest = glm::max(glm::max(std::abs(v.x), std::abs(v.y)), std::abs(v.z));
    return largest > 0 && std::isfinite(largest) ? largest * length(v / largest) : largest;
}

DVec3 unit(const DVec3& v) { return v / safe_length(v); }

/// An orthonormal frame about a unit axis, in double: from far away float directions would miss the scene.
struct WideFrame {
    DVec3 x, y, z;

    explicit WideFrame(const DVec3& axis) : z(axis) {
        const DVec3 near_x(frame_about(Vec3(axis)).x);
        x = normalize(near_x - dot(near_x, z) * z);
        y = cross(z, x);
    }
    DVec3 to_world(const DVec3& v) const { return v.x * x + v.y * y + v.z * z; }
};

/// Directions within an angle of an axis.
struct Cone {
    DVec3 axis{0, 0, 1};
    double below = 2;  // 1 - cos(half angle): all round

    double solid_angle() const { return 2 * kPi64 * below; }
    DVec3 sample(const Vec2& u) const {
        const double down = double(u.x) * below, turn = 2 * kPi64 * double(u.y);
        const double radius = safe_sqrt(down * (2 - down));
        return WideFrame(axis).to_world({radius * std::cos(turn), radius * std::sin(turn), 1 - down});
    }
};

/// Where the sphere lies as seen from `from`.
Cone cone_towards(const Sphere& sphere, const DVec3& from) {
    const DVec3 to_center = sphere.center - from;
    const double distance = safe_length(to_center);
    if (distance <= sphere.radius) return {};
    const double sine_squared = square(sphere.radius / distance);
    return {to_center / distance, sine_squared / (1 + std::sqrt(1 - sine_squared))};
}

/// A spot's own cone or that about the sphere, whichever is narrower.
Cone cone_of(const SpotLight& light, const Sphere& sphere) {
    const Cone to_sphere = cone_towards(sphere, light.position);
    const DVec3 axis = light.to - light.position;
    const double distance = safe_length(axis);
    if (!(distance > 0)) return {to_sphere.axis, 0};
    const double below = 2 * square(std::sin(0.25 * glm::radians(light.angle)));
    return below < to_sphere.below ? Cone{axis / distance, below} : to_sphere;
}

/// From farther than this, in radii of the sphere, all ways to it are parallel: its points differ by less than rounding
/// in single precision.
constexpr double kFarAway = 1e8;

/// Where a ray comes into the sphere: its origin if that is inside, nothing if it passes.
std::optional<DVec3> enter(const Sphere& sphere, const DVec3& origin, const DVec3& direction) {
    const DVec3 from_center = origin - sphere.center;
    if (safe_length(from_center) > kFarAway * sphere.radius) return {};  // a direction does not tell where it gets
    const double to_closest = -dot(from_center, direction);
    const double across_squared =
        square(sphere.radius) - dot(from_center + to_closest * direction, from_center + to_closest * direction);
    if (across_squared < 0) return {};
    const double half = std::sqrt(across_squared);
    if (to_closest + half <= 0) return {};
    return origin + glm::max(to_closest - half, 0.0) * direction;
}

Emission starting(const Sphere& sphere, const DVec3& origin, const DVec3& direction, const Rgb& power) {
    const std::optional<DVec3> entry = enter(sphere, origin, direction);
    return entry ? Emission{Vec3(*entry), Vec3(direction), power} : Emission{};
}

/// Light that comes the same way from infinitely far, over a disc as wide as the sphere.
Emission from_infinity(const Sphere& sphere, const DVec3& direction, const Vec2& u, const Rgb& power) {
    const Vec2 disc = sample_concentric_disc(u);
    const double x = double(disc.x), y = double(disc.y), above = safe_sqrt(1 - x * x - y * y);
    const DVec3 entry = sphere.center + sphere.radius * WideFrame(direction).to_world({x, y, -above});
    return {Vec3(entry), Vec3(direction), power};
}

/// Uniform in a cone from a point.
Emission within(const Cone& cone, const DVec3& from, const Sphere& sphere, const glm::vec4& u, const Rgb& power) {
    const Vec2 pair(u.x, u.y);
    const bool far_away = safe_length(from - sphere.center) > kFarAway * sphere.radius;
    return far_away ? from_infinity(sphere, cone.axis, pair, power) : starting(sphere, from, cone.sample(pair), power);
}

/// Whether a lamp's surface rather aims at the sphere than shines all over its hemisphere (whose cosines sum to pi).
bool aims(const Cone& to_sphere) { return to_sphere.solid_angle() < kPi64; }

double disc_area(const Sphere& sphere) { return kPi64 * square(sphere.radius); }

}  // namespace

Sphere sphere_about(const Bounds& bounds) {
    if (bounds.empty()) return {};
    constexpr double kGrowth = 1 + 0x1p-16;  // far more than what rounds away when points of it become floats
    const DVec3 lo(bounds.lo), hi(bounds.hi);
    return {0.5 * (lo + hi), 0.5 * kGrowth * length(hi - lo)};
}

Rgb emission_power(const PointLight& light, const Sphere& sphere) {
    return bounded(DVec3(light.intensity) * cone_towards(sphere, light.position).solid_angle());
}

Rgb emission_power(const SpotLight& light, const Sphere& sphere) {
    return bounded(DVec3(light.intensity) * cone_of(light, sphere).solid_angle());
}

Rgb emission_power(const DistantLight& light, const Sphere& sphere) {
    const bool directed = safe_length(light.direction) > 0;
    return directed ? bounded(DVec3(light.irradiance) * disc_area(sphere)) : Rgb(0);
}

/// At its middle, never less than where the sphere stands half behind the lamp's plane.
Rgb emission_power(const QuadLight& light, const Sphere& sphere) {
    const DVec3 area_normal = cross(light.edge[0], light.edge[1]);
    const double area = safe_length(area_normal);
    if (!(area > 0)) return Rgb(0);
    const Cone cone = cone_towards(sphere, light.corner + 0.5 * (light.edge[0] + light.edge[1]));
    if (!aims(cone)) return bounded(DVec3(light.radiance) * (kPi64 * area));
    const double sine = std::sqrt(cone.below * (2 - cone.below)), cosine = dot(cone.axis, area_normal / area);
    return bounded(DVec3(light.radiance) * (area * cone.solid_angle() * glm::max(cosine, sine)));
}

Emission emit(const PointLight& light, const Sphere& sphere, const glm::vec4& u) {
    const Rgb power = emission_power(light, sphere);
    if (!is_light(power)) return {};
    return within(cone_towards(sphere, light.position), light.position, sphere, u, power);
}

Emission emit(const SpotLight& light, const Sphere& sphere, const glm::vec4& u) {
    const Rgb power = emission_power(light, sphere);
    if (!is_light(power)) return {};
    const Emission emission = within(cone_of(light, sphere), light.position, sphere, u, power);
    return double(u.z) < spot_falloff(light, DVec3(emission.direction)) ? emission : Emission{};
}

Emission emit(const DistantLight& light, const Sphere& sphere, const glm::vec4& u) {
    const Rgb power = emission_power(light, sphere);
    if (!is_light(power)) return {};
    return from_infinity(sphere, unit(light.direction), {u.x, u.y}, power);
}

Emission emit(const QuadLight& light, const Sphere& sphere, const glm::vec4& u) {
    if (!is_light(emission_power(light, sphere))) return {};
    const DVec3 area_normal = cross(light.edge[0], light.edge[1]), normal = unit(area_normal);
    const DVec3 on_quad = light.corner + double(u.x) * light.edge[0] + double(u.y) * light.edge[1];
    const DVec3 flux = DVec3(light.radiance) * safe_length(area_normal);  // times solid angle and cosine
    const Cone cone = cone_towards(sphere, on_quad);
    Emission emission;
    if (aims(cone)) {
        emission = within(cone, on_quad, sphere, {u.z, u.w, 0, 0}, Rgb(1));
        const double cosine = glm::max(dot(DVec3(emission.direction), normal), 0.0);
        emission.power *= bounded(flux * (cone.solid_angle() * cosine));
    } else {
        const DVec3 direction = WideFrame(normal).to_world(DVec3(sample_cosine_hemisphere({u.z, u.w})));
        emission = starting(sphere, on_quad, direction, bounded(flux * kPi64));
    }
    // A lamp may lie in a polygon's plane, as in a ceiling: photons start clear of its rounding.
    constexpr float kUlps = 64 * std::numeric_limits<float>::epsilon();
    const float largest = max_component(abs(emission.position)) + float(sphere.radius);
    emission.position += Vec3(normal) * (kUlps * largest);
    return emission;
}

Emission emit(const EnvironmentSampler& light, const Sphere& sphere, const glm::vec4& u) {
    const EnvironmentSample from = sample_environment(light, {u.x, u.y});
    if (!(from.pdf > 0)) return {};
    const Rgb power = bounded(DVec3(from.radiance) * (disc_area(sphere) / double(from.pdf)));
    if (!is_light(power)) return {};
    return from_infinity(sphere, normalize(-DVec3(from.direction)), {u.z, u.w}, power);
}

Rgb emission_power(const EnvironmentSampler& light, const Sphere& sphere) {
    return bounded(DVec3(light.power * disc_area(sphere)));
}

}  // namespace tress
