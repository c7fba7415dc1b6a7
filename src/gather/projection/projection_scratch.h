// SPDX-License-Identifier: MIT
// Arrays that projection keeps between points: one set a thread.
#pragma once

#include <utility>
#include <vector>

#include "gather/projection/arcs.h"
#include "gather/projection/cell_depths.h"
#include "gather/projection/piece_list.h"
#include "gather/projection/projected_segments.h"
#include "gather/projection/splats.h"

namespace tress {

/// What one wide fiber absorbs in the cells that it covers, before that is turned into depth: its parts cover a cell
/// side by side, not one behind another.
struct WideFiber {
    std::vector<Rgbx> absorbed;     // share of each cell's light, one a cell of the sphere; 0 outside the list
    std::vector<uint32_t> touched;  // cells
    std::vector<std::pair<uint32_t, uint32_t>>
        covered;  // by the piece being drawn: a cell, and how many of its samples
};

/// A segment that stands for `weight` like it.
struct ChosenSegment {
    uint32_t segment;
    float weight;
};

/// Segments of which parts are splats.
struct PartedSegments {
    ProjectedSegments rows = make_rows(ProjectedSegments::kStreams);
    AlignedArray<int32_t> kind = AlignedArray<int32_t>(ProjectedSegments::kStreams);  // of HairOpacity
    size_t size = 0;
};

struct ProjectionScratch {
    std::vector<ChosenSegment> chosen;  // by layers of distance
    ProjectedSegments chosen_rows = make_rows(ProjectedSegments::kStreams);
    PartedSegments halved, quartered;
    CellSplats segment_splats;
    Splats splats, cube_splats;  // of arcs, of cubes
    PieceList pieces;
    Arcs arcs{PieceList::kCapacity + PieceList::kPadding};
    std::vector<ArcRow> wide_arcs;  // of the point, in the order of the pieces
    WideFiber wide;
    CellDepths<float> gray;
    CellDepths<Rgbx> color;
};

}  // namespace tress
