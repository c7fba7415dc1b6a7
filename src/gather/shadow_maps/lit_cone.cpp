// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/lit_cone.h"

#include <glm/trigonometric.hpp>

namespace tress {
namespace {

struct ConeOf {
    DVec3 point;

    std::optional<LitCone> operator()(const PointLight&) const { return LitCone{point}; }
    std::optional<LitCone> operator()(const SpotLight& light) const {
        const DVec3 axis = light.to - light.position;
        if (!(length(axis) > 0)) return std::nullopt;
        const double half = 0.5 * glm::radians(light.angle);
        return LitCone{point, normalize(axis), std::sin(half), std::cos(half)};
    }
    std::optional<LitCone> operator()(const QuadLight& light) const {
        const DVec3 normal = cross(light.edge[0], light.edge[1]);
        if (!(length(normal) > 0)) return std::nullopt;
        return LitCone{point, normalize(normal), 1, 0};
    }
    std::optional<LitCone> operator()(const DistantLight&) const { return std::nullopt; }
    std::optional<LitCone> operator()(const EnvironmentLight&) const { return std::nullopt; }
};

}  // namespace

std::optional<LitCone> lit_cone(const Light& light, const DVec3& point) { return std::visit(ConeOf{point}, light); }

ViewRectangle rectangle_of(const LitCone& cone, const DVec3& axis) {
    if (!(cone.cosine > 0)) return kEverywhere;
    const ViewHair ball{{axis, axis}, {cone.sine, cone.sine}};  // the cone touches it all round
    return rectangle_of(ball, Projection::pinhole);
}

}  // namespace tress
