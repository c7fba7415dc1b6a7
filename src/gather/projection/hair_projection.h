// SPDX-License-Identifier: MIT
// Hair as it is projected onto cells about points: what is built once for a scene, and the projection of one point.
//
//     const HairProjection projection = make_hair_projection(segments, attenuation, detail, options);
//     ProjectionScratch scratch;
//     CellLight light;
//     project(projection, segments, from, unseen, isa, scratch);
//     find_light(projection, from, isa, scratch, light);
//     light.transmittance(cell_of(projection.igloo, from.frame.to_local(direction)));
#pragma once

#include "gather/projection/projection_kernels.h"
#include "gather/projection/strand_layers.h"

namespace tress {

/// Of light of type 2 that leaves points for the eye, against rays, relative to its mean.
struct ProjectionError {
    double rms = 0, bias = 0;
    int points = 0;  // 0: none is seen, nothing is known
};

/// What is made of the gaps between cells, and what error is left.
struct CellGap {
    GapShares shares;
    ProjectionError error;
};

struct HairProjection {
    Bounds bounds;  // of all hair
    Igloo igloo;
    HairOpacity opacity;
    ProjectedSegments segments;    // all or simplified; empty where a tree is walked
    StrandLayers layers;           // empty where distance does not choose
    MomentTree tree;               // empty where segments are projected
    ProjectionOptions options;     // with numbers in place of what is automatic, but for the gap
    CellGap at_hair, at_polygons;  // as the options say; where rays shall say, by calibrate_gap

    const CellGap& gap(Dome dome) const { return dome == Dome::sphere ? at_hair : at_polygons; }
};

/// `detail` is not automatic.
HairProjection make_hair_projection(const SegmentView& segments, const Attenuation& attenuation,
                                    ProjectionDetail detail, const Options& options);

/// Depths of the hair about a point, in the frame of `from`, to `scratch`. `hair` is what the projection was made of.
void project(const HairProjection& projection, const SegmentView& hair, const Viewpoint& from, const Unseen& unseen,
             Isa isa, ProjectionScratch& scratch);

/// The same, from what `far` has and the hair in its box. The frame of `from` is that of `far`; the hair is a tree.
void project_near(const HairProjection& projection, const Viewpoint& from, const Unseen& unseen, const FarHair& far,
                  Isa isa, ProjectionScratch& scratch);

/// Far hair of the corner of the grid that is at `from`; `size` is that of the grid's cubes. The hair is a tree.
FarHair find_far_hair(const HairProjection& projection, const Viewpoint& from, float size, Isa isa,
                      ProjectionScratch& scratch);

/// What the hair that was projected lets through; with the projection's shares of gaps, or others.
void find_light(const HairProjection& projection, const Viewpoint& from, Isa isa, const ProjectionScratch& scratch,
                CellLight& light);
void find_light(const HairProjection& projection, const Viewpoint& from, const GapShares& shares, Isa isa,
                const ProjectionScratch& scratch, CellLight& light);

size_t bytes(const HairProjection& projection);

}  // namespace tress
