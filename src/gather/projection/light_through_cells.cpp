// SPDX-License-Identifier: MIT
#include "gather/projection/light_through_cells.h"

#include "gather/projection/viewpoints.h"

namespace tress {

Rgb LightThroughCells::operator()(const PreparedScene& prepared, const ShadingPoint& point, const LightProbe* probe,
                                  std::span<const SeenLight> seen, uint64_t key, Isa isa) {
    if (seen.empty()) return Rgb(0);
    const HairProjection& hair = prepared.projection;
    Viewpoint& from = from_ = viewpoint_of(point, key);
    const bool polygons = probe && !probe->cells.empty(), shared = probe && !probe->far.empty();
    if (shared) from.frame = probe->frame;
    if (polygons) {
        projection_kernels(isa).find_sight(*probe, prepared.probes->igloo(), hair.igloo, from, sight_);
        from.sight = std::span(sight_).first(hair.igloo.cells_of(from.dome));
    }
    if (shared)
        project_near(hair, from, unseen_from(point, prepared.segments), probe->far, isa, scratch_, cells_);
    else
        project(hair, prepared.segments, from, unseen_from(point, prepared.segments), isa, scratch_, cells_);
    return sum_of(hair.igloo, seen);
}

Rgb LightThroughCells::with_gaps(const PreparedScene& prepared, std::span<const SeenLight> seen,
                                 const GapShares& shares, Isa isa) {
    if (seen.empty()) return Rgb(0);
    find_light(prepared.projection, from_, shares, isa, scratch_, cells_);
    return sum_of(prepared.projection.igloo, seen);
}

Rgb LightThroughCells::sum_of(const Igloo& igloo, std::span<const SeenLight> seen) const {
    Rgb sum(0);
    for (const SeenLight& light : seen) {
        const uint32_t cell = cell_of(igloo, from_.frame.to_local(light.direction));
        if (cell >= cells_.cells) continue;  // below a polygon's horizon
        if (!light.among_hair)
            sum += light.radiance * cells_.transmittance(cell);
        else if (!from_.sight.empty())
            sum += light.radiance * cells_.transmittance_in_sight(cell);
    }
    return sum;
}

}  // namespace tress
