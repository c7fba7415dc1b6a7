// SPDX-License-Identifier: MIT
#include "gather/projection/hair_projection.h"

#include "gather/projection/simplified_hair.h"

namespace tress {
namespace {

constexpr float kCubesAcross = 256;  // of the smallest, over the hair

}  // namespace

HairProjection make_hair_projection(const SegmentView& segments, const Attenuation& attenuation,
                                    ProjectionDetail detail, const Options& options) {
    HairProjection p;
    p.options = options.projection;
    p.options.detail = detail;
    p.bounds = bounds(segments);
    p.igloo = make_igloo(uint32_t(p.options.cells));
    p.opacity = make_hair_opacity(attenuation);
    switch (detail) {
        case ProjectionDetail::tree:
            if (p.options.cube == 0) p.options.cube = max_component(p.bounds.extent()) / kCubesAcross;
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
             ProjectionScratch& scratch, CellLight& light) {
    const ProjectionInput in{
        p.igloo, p.opacity, p.segments, p.tree, p.options.opening, p.options.splats, std::max(p.options.gap, 0.0f)};
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
    kernels.find_light(in, from, scratch, light);
}

size_t bytes(const HairProjection& p) { return bytes(p.opacity) + bytes(p.segments) + bytes(p.layers) + bytes(p.tree); }

}  // namespace tress
