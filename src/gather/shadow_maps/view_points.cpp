// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/fit_views.h"

namespace tress {
namespace {

struct PointsOf {
    int grid;

    std::vector<DVec3> operator()(const PointLight& light) const { return {light.position}; }
    std::vector<DVec3> operator()(const SpotLight& light) const { return {light.position}; }
    std::vector<DVec3> operator()(const DistantLight&) const { return {DVec3(0)}; }
    std::vector<DVec3> operator()(const EnvironmentLight&) const { return {DVec3(0)}; }
    std::vector<DVec3> operator()(const QuadLight& light) const {
        std::vector<DVec3> points;
        for (int j = 0; j < grid; ++j) {
            for (int i = 0; i < grid; ++i) {
                const double x = (i + (j + 0.5) / grid) / grid, y = (j + (i + 0.5) / grid) / grid;
                points.push_back(light.corner + x * light.edge[0] + y * light.edge[1]);
            }
        }
        return points;
    }
};

}  // namespace

std::vector<DVec3> view_points(const Light& light, int grid) { return std::visit(PointsOf{grid}, light); }

size_t view_point_of(const Light& light, int grid, const Vec2& u) {
    if (!std::holds_alternative<QuadLight>(light)) return 0;
    const auto cell = [&](float share) { return size_t(glm::clamp(int(share * float(grid)), 0, grid - 1)); };
    return cell(u.y) * size_t(grid) + cell(u.x);
}

}  // namespace tress
