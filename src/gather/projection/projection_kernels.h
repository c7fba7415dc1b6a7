// SPDX-License-Identifier: MIT
// Projection as compiled for one instruction set. Only the sources of this folder need this.
#pragma once

#include "core/options.h"
#include "gather/projection/cell_light.h"
#include "gather/projection/far_hair.h"
#include "gather/projection/light_probe.h"
#include "gather/projection/projected_segments.h"
#include "gather/projection/projection_scratch.h"

namespace tress {

/// What is projected: everything that does not depend on the point.
struct ProjectionInput {
    const Igloo& igloo;
    const HairOpacity& opacity;
    const ProjectedSegments& segments;  // empty where the tree is walked
    const MomentTree& tree;             // empty where segments are projected
    float opening;                      // cubes larger than this many cells are opened
    float sub_splats;                   // splats of a cube as large as a cell
    float near;                         // share of a cell: wider hair is told apart by samples
};

struct ProjectionKernels {
    /// Adds every segment, those of scratch.chosen, or the tree to the cells of scratch.gray or scratch.color, and hair
    /// next to the point to those of scratch.near, which are cleared before.
    void (*project_segments)(const ProjectionInput&, const Viewpoint&, const Unseen&, ProjectionScratch&);
    void (*project_chosen)(const ProjectionInput&, const Viewpoint&, const Unseen&, ProjectionScratch&);
    void (*project_tree)(const ProjectionInput&, const Viewpoint&, const Unseen&, ProjectionScratch&);
    /// Likewise, but starting from the depths of `far`: the hair in its box. And all hair but that, whose cubes are
    /// then listed in `far`.
    void (*project_near)(const ProjectionInput&, const Viewpoint&, const Unseen&, const FarHair& far,
                         ProjectionScratch&);
    void (*project_far)(const ProjectionInput&, const Viewpoint&, FarHair& far, ProjectionScratch&);
    /// From depths and hair next to the point to light.
    void (*find_light)(const ProjectionInput&, const Viewpoint&, const GapShares&, const ProjectionScratch&,
                       CellLight&);
    /// Squared distance of polygons among the hair in each cell of a viewpoint near the probe; infinity where there are
    /// none.
    void (*find_sight)(const LightProbe&, const Igloo& of_probe, const Igloo&, const Viewpoint&, std::vector<float>&);
};

ProjectionKernels projection_kernels(Isa isa);

}  // namespace tress
