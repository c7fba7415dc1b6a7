// SPDX-License-Identifier: MIT
#include "gather/projection/make_light_probe.h"

#include "accel/queries.h"
#include "core/rng.h"
#include "gather/connection.h"
#include "gather/polygon_light.h"
#include "gather/projection/box_passage.h"
#include "gather/projection/viewpoints.h"

namespace tress {
LightProbe make_light_probe(const Scene& scene, const PreparedScene& prepared, const Plan& plan, const Igloo& igloo,
                            const Vec3& position, const Excluded& excluded, uint64_t key, Isa isa) {
    LightProbe probe;
    probe.position = position;
    probe.frame = turned_at_random(key);
    if (prepared.mesh.empty()) return probe;
    const uint32_t cells = igloo.cells_of(Dome::sphere);
    RayBuffer rays;
    for (uint32_t cell = 0; cell < cells; ++cell) {
        const uint64_t own = hash(key, cell);
        const Vec3 local = direction_in(igloo, cell, {random(own, 0), random(own, 1)});
        rays.add(position, probe.frame.to_world(local), kInfinity, excluded);
    }
    std::vector<uint32_t> polygon(cells, kNone);
    std::vector<float> t(cells, kInfinity), u(cells), v(cells);
    nearest_triangle(prepared.mesh, rays.for_mesh(), {t, polygon, u, v}, isa);
    probe.cells.resize(cells);
    for (uint32_t cell = 0; cell < cells; ++cell) {
        if (polygon[cell] == kNone) continue;
        const Vec3 direction = rays.direction(cell);
        const bool among = passage(prepared.projection.bounds, position, direction).holds(t[cell]);
        probe.cells[cell].signed_distance = among ? -t[cell] : t[cell];
        if (plan.polygon_gather)
            probe.cells[cell].radiance = pack(bounded(polygon_radiance(
                scene, prepared.photons.irradiance, polygon[cell], position + t[cell] * direction, direction)));
    }
    return probe;
}

}  // namespace tress
