// SPDX-License-Identifier: MIT
#include "core/light_reach.h"

#include <glm/trigonometric.hpp>

namespace tress {
namespace {

struct EmissionOf {
    Rgb operator()(const PointLight& light) const { return light.intensity; }
    Rgb operator()(const SpotLight& light) const { return light.intensity; }
    Rgb operator()(const DistantLight& light) const { return light.irradiance; }
    Rgb operator()(const QuadLight& light) const { return light.radiance; }
    Rgb operator()(const EnvironmentLight& light) const {
        Rgb brightest = light.image.empty() ? Rgb(1) : Rgb(0);
        for (const Rgb& texel : light.image.pixel) brightest = max(brightest, texel);
        return brightest * light.radiance;
    }
};

struct ShapeUnseen {
    const Bounds& bounds;

    std::string operator()(const PointLight&) const { return ""; }
    std::string operator()(const DistantLight& light) const {
        return dot(light.direction, light.direction) > 0 ? "" : "it has no direction";
    }
    std::string operator()(const EnvironmentLight&) const { return ""; }

    /// Cone against the sphere about the scene's box: outside when the angle to the centre exceeds the cone's by more
    /// than the angle that the sphere spans.
    std::string operator()(const SpotLight& light) const {
        const DVec3 to_scene = DVec3(bounds.center()) - light.position, axis = light.to - light.position;
        const double radius = 0.5 * length(DVec3(bounds.extent())), d = length(to_scene);
        if (length(axis) == 0 || d <= radius) return "";
        const double angle = std::acos(glm::clamp(dot(to_scene, axis) / (d * length(axis)), -1.0, 1.0));
        return angle > 0.5 * glm::radians(light.angle) + std::asin(radius / d) ? "its cone misses everything" : "";
    }
    std::string operator()(const QuadLight& light) const {
        const DVec3 normal = cross(light.edge[0], light.edge[1]);
        if (dot(normal, normal) == 0) return "it has no area";
        const DVec3 center(bounds.center()), half = 0.5 * DVec3(bounds.extent());
        const double farthest = dot(center - light.corner, normal) + dot(half, abs(normal));
        return farthest <= 0 ? "everything is behind its shining side" : "";
    }
};

}  // namespace

const char* light_name(const Light& light) {
    constexpr const char* names[] = {"point", "spot", "distant", "quad", "environment"};
    static_assert(std::size(names) == std::variant_size_v<Light>);
    return names[light.index()];
}

std::string why_unseen(const Light& light, const Bounds& bounds) {
    if (max_component(std::visit(EmissionOf{}, light)) <= 0) return "it is black";
    return std::visit(ShapeUnseen{bounds}, light);
}

}  // namespace tress
