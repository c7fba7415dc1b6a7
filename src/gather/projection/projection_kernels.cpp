// SPDX-License-Identifier: MIT
#include "gather/projection/projection_kernels.h"

#include "accel/highway_targets.h"
#include "accel/isa_targets.h"

#define HWY_TARGET_INCLUDE "gather/projection/projection_kernels.cpp"
// foreach_target.h compiles what follows it once a target, and must stand first.
// clang-format off
#include "hwy/foreach_target.h"
#include "gather/projection/all_segments-inl.h"
#include "gather/projection/cell_light-inl.h"
#include "gather/projection/moment_walk-inl.h"
#include "gather/projection/sight-inl.h"
#include "hwy/highway.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

/// Calls run(depths) with the cleared sums of as many channels as the hair needs; clears what is near.
template <class Run>
void with_depths(const ProjectionInput& in, const Viewpoint& from, ProjectionScratch& scratch, const Run& run) {
    const size_t cells = in.igloo.cells_of(from.dome) * (from.sight.empty() ? 1 : 2);
    scratch.near.clear(cells);
    if (in.opacity.gray) {
        scratch.gray.clear(cells);
        run(scratch.gray);
    } else {
        scratch.color.clear(cells);
        run(scratch.color);
    }
}

void project_segments_of(const ProjectionInput& in, const Viewpoint& from, const Unseen& unseen,
                         ProjectionScratch& scratch) {
    with_depths(in, from, scratch, [&](auto& depths) { project_segments(in, from, unseen, scratch, depths); });
}

void project_chosen_of(const ProjectionInput& in, const Viewpoint& from, const Unseen& unseen,
                       ProjectionScratch& scratch) {
    with_depths(in, from, scratch, [&](auto& depths) { project_chosen(in, from, unseen, scratch, depths); });
}

void project_tree_of(const ProjectionInput& in, const Viewpoint& from, const Unseen& unseen,
                     ProjectionScratch& scratch) {
    with_depths(in, from, scratch, [&](auto& depths) { MomentWalk(in, from, unseen, scratch, depths).everything(); });
}

void project_near_of(const ProjectionInput& in, const Viewpoint& from, const Unseen& unseen, const FarHair& far,
                     ProjectionScratch& scratch) {
    const auto run = [&](auto& depths) {
        depths.start(far);
        scratch.near.clear(depths.cells);
        MomentWalk(in, from, unseen, scratch, depths).near(far);
    };
    if (in.opacity.gray)
        run(scratch.gray);
    else
        run(scratch.color);
}

void project_far_of(const ProjectionInput& in, const Viewpoint& from, FarHair& far, ProjectionScratch& scratch) {
    with_depths(in, from, scratch, [&](auto& depths) { MomentWalk(in, from, {}, scratch, depths).beyond(far); });
}

void find_light(const ProjectionInput& in, const Viewpoint& from, const GapShares& gaps,
                const ProjectionScratch& scratch, CellLight& to) {
    to.gray = in.opacity.gray;
    to.cells = in.igloo.cells_of(from.dome);
    const auto find = [&](bool in_sight, CellTransmittance& light) {
        let_through_near(scratch.near, to.cells, in_sight, to.gray, light);
        if (to.gray) return find_channel<0>(in.igloo, scratch.gray, to.cells, in_sight, gaps, light);
        find_channel<0>(in.igloo, scratch.color, to.cells, in_sight, gaps, light);
        find_channel<1>(in.igloo, scratch.color, to.cells, in_sight, gaps, light);
        find_channel<2>(in.igloo, scratch.color, to.cells, in_sight, gaps, light);
    };
    find(false, to.all);
    if (!from.sight.empty()) find(true, to.in_sight);
}

ProjectionKernels kernels_here() {
    return {project_segments_of, project_chosen_of, project_tree_of, project_near_of,
            project_far_of,      find_light,        find_sight};
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tress {
namespace {
HWY_EXPORT(kernels_here);
}

ProjectionKernels projection_kernels(Isa isa) { return HWY_DISPATCH_TABLE(kernels_here)[kernel_index(isa)](); }

}  // namespace tress
#endif
