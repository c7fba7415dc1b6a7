// SPDX-License-Identifier: MIT
// Scenes turned as a whole, and their strands in other orders.
#pragma once

#include <algorithm>
#include <glm/gtc/quaternion.hpp>
#include <numeric>
#include <type_traits>

#include "core/rng.h"
#include "core/scene.h"

namespace tress::test {

/// Any turn, all as likely (Shoemake 1992).
inline glm::dmat3 random_turn(uint64_t key) {
    const double u = double(random(key, 0)), tau = 2 * double(kPi);
    const double a = tau * double(random(key, 1)), b = tau * double(random(key, 2));
    const double s = std::sqrt(1 - u), c = std::sqrt(u);
    return glm::mat3_cast(glm::dquat(c * std::cos(b), s * std::sin(a), s * std::cos(a), c * std::sin(b)));
}

struct TurnLight {
    const glm::dmat3& by;

    void operator()(PointLight& light) const { light.position = by * light.position; }
    void operator()(SpotLight& light) const {
        light.position = by * light.position;
        light.to = by * light.to;
    }
    void operator()(DistantLight& light) const { light.direction = by * light.direction; }
    void operator()(QuadLight& light) const {
        light.corner = by * light.corner;
        for (DVec3& edge : light.edge) edge = by * edge;
    }
    void operator()(EnvironmentLight&) const {}  // of one radiance: the same all round
};

/// About the origin: hair, polygons, lights and camera.
inline Scene turned(Scene scene, const glm::dmat3& by) {
    const auto turn = [&](auto& points) {
        for (size_t i = 0; i < points.x.size(); ++i) {
            const Vec3 p(by * DVec3(points.x[i], points.y[i], points.z[i]));
            points.x[i] = p.x, points.y[i] = p.y, points.z[i] = p.z;
        }
    };
    turn(scene.hair);
    turn(scene.mesh);
    for (Vec3& normal : scene.mesh.normal) normal = Vec3(by * DVec3(normal));
    for (Light& light : scene.lights) std::visit(TurnLight{by}, light);
    for (DVec3* v : {&scene.camera.from, &scene.camera.to, &scene.camera.up}) *v = by * *v;
    scene.bounds = bounds(view(scene.hair, scene.segments));
    for (size_t i = 0; i < scene.mesh.vertices(); ++i) scene.bounds.add(scene.mesh.vertex(i));
    return scene;
}

/// Points of `from`, strand after strand as `order` lists them, each from its tip where `reversed`.
inline StrandSet in_order(const StrandSet& from, const std::vector<uint32_t>& order, bool reversed) {
    StrandSet to;
    to.constant_radius = from.constant_radius;
    to.first = {0};
    for (const uint32_t strand : order) {
        const uint32_t first = from.first[strand], end = from.first[strand + 1];
        for (uint32_t i = 0; i < end - first; ++i) {
            const uint32_t p = reversed ? end - 1 - i : first + i;
            to.add_point(from.point(p));
            if (!from.radius.empty()) to.radius.push_back(from.radius[p]);
            if (!from.color.empty()) to.color.push_back(from.color[p]);
        }
        to.first.push_back(uint32_t(to.points()));
    }
    return to;
}

inline StrandSet shuffled(const StrandSet& strands, uint64_t key) {
    std::vector<uint32_t> order(strands.strands());
    std::iota(order.begin(), order.end(), 0u);
    for (size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[hash(key, i) % i]);
    return in_order(strands, order, false);
}

inline StrandSet reversed(const StrandSet& strands) {
    std::vector<uint32_t> order(strands.strands());
    std::iota(order.begin(), order.end(), 0u);
    return in_order(strands, order, true);
}

}  // namespace tress::test
