// SPDX-License-Identifier: MIT
#include "gather/projection/make_light_probe.h"

#include "accel/queries.h"
#include "core/rng.h"
#include "gather/polygon_light.h"
#include "gather/projection/box_passage.h"
#include "gather/projection/viewpoints.h"

namespace tress {
namespace {

void find_among_hair(const Bounds& hair, const RayBuffer& rays, LightProbe& probe) {
    probe.among_distance.assign(rays.size() + Igloo::kPadding, kInfinity);
    for (size_t i = 0; i < rays.size(); ++i) {
        const Vec3 direction = rays.direction(i);
        if (!passage(hair, probe.position, direction).holds(probe.distance[i])) continue;
        probe.among_distance[i] = probe.distance[i];
        const Vec3 seen = probe.distance[i] * direction;
        probe.among_x.push_back(seen.x), probe.among_y.push_back(seen.y), probe.among_z.push_back(seen.z);
    }
    while (!probe.among_x.empty() && probe.among_x.size() % Igloo::kPadding != 0) {  // the last again: no more is seen
        probe.among_x.push_back(probe.among_x.back());
        probe.among_y.push_back(probe.among_y.back());
        probe.among_z.push_back(probe.among_z.back());
    }
}

}  // namespace

LightProbe make_light_probe(const Scene& scene, const PreparedScene& prepared, const Plan& plan, const Igloo& igloo,
                            const Vec3& position, const Excluded& excluded, uint64_t key, Isa isa) {
    LightProbe probe;
    probe.position = position;
    probe.frame = turned_at_random(key);
    const uint32_t cells = igloo.cells_of(Dome::sphere);
    RayBuffer rays;
    for (uint32_t cell = 0; cell < cells; ++cell) {
        const uint64_t own = hash(key, cell);
        const Vec3 local = direction_in(igloo, cell, {random(own, 0), random(own, 1)});
        rays.add(position, probe.frame.to_world(local), kInfinity, excluded);
    }
    std::vector<uint32_t> polygon(cells, kNone);
    std::vector<float> u(cells), v(cells);
    probe.distance.assign(cells, kInfinity);
    nearest_triangle(prepared.mesh, rays.for_mesh(), {probe.distance, polygon, u, v}, isa);
    find_among_hair(prepared.projection.bounds, rays, probe);
    probe.radiance.assign(cells, Rgb(0));
    if (!plan.polygon_gather) return probe;
    for (uint32_t cell = 0; cell < cells; ++cell) {
        if (polygon[cell] == kNone) continue;
        const Vec3 direction = rays.direction(cell);
        probe.radiance[cell] = polygon_radiance(scene, prepared.photons.irradiance, polygon[cell],
                                                position + probe.distance[cell] * direction, direction);
    }
    return probe;
}

}  // namespace tress
