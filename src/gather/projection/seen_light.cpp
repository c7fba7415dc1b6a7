// SPDX-License-Identifier: MIT
#include "gather/projection/seen_light.h"

#include "gather/connection.h"
#include "gather/polygon_light.h"
#include "gather/projection/box_passage.h"

namespace tress {
namespace {

void add(const SeenLight& light, std::vector<SeenLight>& to) {
    if (is_finite(light.radiance) && max_component(light.radiance) > 0)
        to.push_back({light.direction, bounded(light.radiance), light.distance, light.among_hair});
}

}  // namespace

void find_seen_light(const LightProbe& probe, const Igloo& igloo, const ShadingPoint& point,
                     std::span<const DrawnDirection> directions, std::vector<SeenLight>& to) {
    to.clear();
    for (const DrawnDirection& d : directions) {
        const ProbeCell& cell = probe.cells[cell_towards(probe, igloo, point.position, d.direction)];
        const Rgb radiance = cell.is_sky() ? d.from_sky : d.weight * unpack(cell.radiance);
        add({d.direction, radiance, cell.distance(), cell.is_among_hair()}, to);
    }
}

void SeenLightByRays::operator()(const Scene& scene, const PreparedScene& prepared, const Plan& plan,
                                 const Options& options, const ShadingPoint& point,
                                 std::span<const DrawnDirection> directions, std::vector<SeenLight>& to) {
    to.clear();
    const size_t n = directions.size();
    for (auto* floats : {&t_, &u_, &v_}) floats->assign(n, kInfinity);
    polygon_.assign(n, kNone);
    if (!prepared.mesh.empty()) {
        rays_.clear();
        for (const DrawnDirection& d : directions) rays_.add(point.position, d.direction, kInfinity, point.excluded);
        nearest_triangle(prepared.mesh, rays_.for_mesh(), {t_, polygon_, u_, v_}, options.isa);
    }
    for (size_t i = 0; i < n; ++i) {
        const DrawnDirection& d = directions[i];
        if (polygon_[i] == kNone) {
            add({d.direction, d.from_sky, kInfinity, false}, to);
            continue;
        }
        if (!plan.polygon_gather || !(max_component(d.weight) > 0)) continue;
        const bool among = passage(prepared.projection.bounds, point.position, d.direction).holds(t_[i]);
        add({d.direction,
             d.weight * polygon_radiance(scene, prepared.photons.irradiance, polygon_[i],
                                         point.position + t_[i] * d.direction, d.direction),
             t_[i], among},
            to);
    }
}

}  // namespace tress
