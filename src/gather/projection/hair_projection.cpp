// SPDX-License-Identifier: MIT
#include "gather/projection/hair_projection.h"

#include "gather/projection/hair_cube.h"
#include "gather/projection/simplified_hair.h"

namespace tress {
namespace {

constexpr float kCubesAcross = 256;  // of the smallest, over the hair

ProjectionInput input_of(const HairProjection& p) {
    return {p.igloo, p.opacity, p.segments, p.tree, p.options.opening, p.options.splats, p.options.near};
}

Rgb color(float depth) { return Rgb(depth); }
Rgb color(const Rgbx& depth) { return {depth.c[0], depth.c[1], depth.c[2]}; }

template <class Depth>
std::vector<PackedDepth> packed(const CellDepths<Depth>& depths, const NearCells& near) {
    std::vector<PackedDepth> to(depths.cells);
    for (size_t cell = 0; cell < depths.cells; ++cell)
        to[cell] = pack_depth(color(depths.sum(cell)) - log(color(near.cells[cell].transmittance())));
    return to;
}

}  // namespace

HairProjection make_hair_projection(const SegmentView& segments, const Attenuation& attenuation,
                                    ProjectionDetail detail, const Options& options) {
    HairProjection p;
    p.options = options.projection;
    p.options.detail = detail;
    if (p.options.gap >= 0) p.at_hair.shares = p.at_polygons.shares = {p.options.gap, p.options.scatter};
    p.bounds = bounds(segments);
    p.igloo = make_igloo(uint32_t(p.options.cells));
    p.opacity = make_hair_opacity(attenuation);
    switch (detail) {
        case ProjectionDetail::tree:
            if (p.options.cube == 0) p.options.cube = 2 * hair_cube(p.bounds).half / kCubesAcross;
            p.tree = make_moment_tree(segments, p.opacity, {p.options.leaf, p.options.cube});
            break;
        case ProjectionDetail::simplified:
            p.segments = simplify_hair(segments, p.options);
            break;
        case ProjectionDetail::layers:
            p.layers = make_strand_layers(segments);
            [[fallthrough]];
        default:
            p.segments = make_projected_segments(segments);
    }
    return p;
}

void project(const HairProjection& p, const SegmentView& hair, const Viewpoint& from, const Unseen& unseen, Isa isa,
             ProjectionScratch& scratch) {
    const ProjectionInput in = input_of(p);
    const ProjectionKernels kernels = projection_kernels(isa);
    switch (p.options.detail) {
        case ProjectionDetail::tree:
            kernels.project_tree(in, from, unseen, scratch);
            break;
        case ProjectionDetail::layers:
            choose_segments(p.layers, hair, p.options, from.position, scratch.chosen);
            kernels.project_chosen(in, from, unseen, scratch);
            break;
        default:
            kernels.project_segments(in, from, unseen, scratch);
    }
}

void project_near(const HairProjection& p, const Viewpoint& from, const Unseen& unseen, const FarHair& far, Isa isa,
                  ProjectionScratch& scratch) {
    projection_kernels(isa).project_near(input_of(p), from, unseen, far, scratch);
}

FarHair find_far_hair(const HairProjection& p, const Viewpoint& from, float size, Isa isa, ProjectionScratch& scratch) {
    const ProjectionInput in = input_of(p);
    FarHair far;
    far.near_box = {from.position - p.tree.origin, kNearCubes * size, size};
    projection_kernels(isa).project_far(in, from, far, scratch);
    far.near.shrink_to_fit();
    far.depth = p.opacity.gray ? packed(scratch.gray, scratch.near) : packed(scratch.color, scratch.near);
    return far;
}

void find_light(const HairProjection& p, const Viewpoint& from, Isa isa, const ProjectionScratch& scratch,
                CellLight& light) {
    find_light(p, from, p.gap(from.dome).shares, isa, scratch, light);
}

void find_light(const HairProjection& p, const Viewpoint& from, const GapShares& shares, Isa isa,
                const ProjectionScratch& scratch, CellLight& light) {
    projection_kernels(isa).find_light(input_of(p), from, shares, scratch, light);
}

size_t bytes(const HairProjection& p) { return bytes(p.opacity) + bytes(p.segments) + bytes(p.layers) + bytes(p.tree); }

}  // namespace tress
