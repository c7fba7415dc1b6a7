// SPDX-License-Identifier: MIT
#include "gather/projection/light_through_cells.h"

#include "gather/projection/viewpoints.h"

namespace tress {

void LightThroughCells::project(const PreparedScene& prepared, const ShadingPoint& point, const LightProbe* probe,
                                uint64_t key, Isa isa) {
    const HairProjection& hair = prepared.projection;
    const Unseen unseen = unseen_from(point, prepared.segments);
    const bool polygons = probe && !probe->cells.empty(), shared = probe && !probe->far.empty();
    from_ = viewpoint_of(point, key);
    if (shared) from_.frame = probe->frame;
    if (polygons) {
        projection_kernels(isa).find_sight(*probe, prepared.probes->igloo(), hair.igloo, from_, sight_);
        from_.sight = std::span(sight_).first(hair.igloo.cells_of(from_.dome));
    }
    if (shared)
        project_near(hair, from_, unseen, probe->far, isa, scratch_);
    else
        tress::project(hair, prepared.segments, from_, unseen, isa, scratch_);
}

Rgb LightThroughCells::light(const PreparedScene& prepared, std::span<const SeenLight> seen, const GapShares& shares,
                             Isa isa) {
    find_light(prepared.projection, from_, shares, isa, scratch_, cells_);
    Rgb sum(0);
    for (const SeenLight& light : seen) {
        const uint32_t cell = cell_of(prepared.projection.igloo, from_.frame.to_local(light.direction));
        if (cell >= cells_.cells) continue;  // below a polygon's horizon
        if (!light.among_hair)
            sum += light.radiance * cells_.transmittance(cell);
        else if (!from_.sight.empty())
            sum += light.radiance * cells_.transmittance_in_sight(cell);
    }
    return sum;
}

}  // namespace tress
