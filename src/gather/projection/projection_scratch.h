// SPDX-License-Identifier: MIT
// Arrays that projection keeps between points: one set a thread.
#pragma once

#include <vector>

#include "gather/projection/arcs.h"
#include "gather/projection/cell_depths.h"
#include "gather/projection/near_cells.h"
#include "gather/projection/piece_list.h"
#include "gather/projection/projected_segments.h"
#include "gather/projection/splats.h"

namespace tress {

/// Of the piece being drawn: a cell, which of its samples are covered, and, of a wide piece, how much of the squares
/// about them.
struct CoveredSamples {
    uint32_t cell;
    uint64_t samples;
    uint32_t parts;
};

/// A segment that stands for `weight` like it.
struct ChosenSegment {
    uint32_t segment;
    float weight;
};

/// Rows of ProjectedSegments, from some row on; up to kPadding past `size` hold anything.
struct RowList {
    static constexpr size_t kCapacity = 256, kPadding = 16;

    AlignedArray<int32_t> row = AlignedArray<int32_t>(kCapacity + kPadding);
    size_t size = 0;

    bool has_room(size_t rows) const { return size + rows <= kCapacity; }
};

/// How a segment too near for one splat is drawn: as two or four splats, or along its arc.
enum class NearWay { halved, quartered, exact };

/// Segments too near for one splat, listed together, then by their ways.
struct NearRows {
    static constexpr int kWays = 3, kWayBits = 2;

    RowList all;  // of row * 2^kWayBits + way, in place of rows
    RowList of_way[kWays];
};

struct ProjectionScratch {
    std::vector<ChosenSegment> chosen;  // by layers of distance
    ProjectedSegments chosen_rows;      // the rows of some of them; empty where none are chosen
    NearRows near_rows;
    CellSplats segment_splats;
    Splats splats, cube_splats;  // of arcs, of cubes
    PieceList pieces;
    Arcs arcs{PieceList::kCapacity + PieceList::kPadding};
    std::vector<ArcRow> near_arcs;  // of the point, in the order of the pieces
    std::vector<NearOrder> near_order;
    std::vector<CoveredSamples> covered;
    NearCells near;
    CellDepths<float> gray;
    CellDepths<Rgbx> color;
};

}  // namespace tress
