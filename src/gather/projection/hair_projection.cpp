// SPDX-License-Identifier: MIT
#include "gather/projection/hair_projection.h"

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
    if (detail == ProjectionDetail::tree) {
        if (p.options.cube == 0) p.options.cube = max_component(p.bounds.extent()) / kCubesAcross;
        p.tree = make_moment_tree(segments, p.opacity, {p.options.leaf, p.options.cube});
    } else {
        p.segments = make_projected_segments(segments);
    }
    return p;
}

void project(const HairProjection& p, const SegmentView& hair, const Viewpoint& from, const Unseen& unseen, Isa isa,
             ProjectionScratch& scratch, CellLight& light) {
    const ProjectionInput in{p.igloo,           p.opacity,          hair, p.segments,       p.tree,
                             p.options.opening, p.options.splats, 1,    std::max(p.options.gap, 0.0f)};
    const ProjectionKernels kernels = projection_kernels(isa);
    (p.options.detail == ProjectionDetail::tree ? kernels.project_tree : kernels.project_segments)(in, from, unseen,
                                                                                                    scratch);
    kernels.find_light(in, from.dome, scratch, light);
}

size_t bytes(const HairProjection& p) { return bytes(p.opacity) + bytes(p.segments) + bytes(p.tree); }

}  // namespace tress
