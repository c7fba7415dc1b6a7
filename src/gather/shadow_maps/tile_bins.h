// SPDX-License-Identifier: MIT
// Ribbons of hair cut into pieces, and which of them are in which tile of a view.
#pragma once

#include <span>
#include <vector>

#include "gather/shadow_maps/ribbon_piece.h"

namespace tress {

/// Pieces are made in parts, each of consecutive segments. A ribbon that is not thin is one piece for
/// all tiles, without what it stops.
struct TileBins {
    struct Name {
        uint32_t part, index;
    };
    std::vector<std::vector<RibbonPiece>> part;
    std::vector<uint64_t> first;  // tile t holds name[first[t]] .. name[first[t + 1] - 1], in the order of segments
    std::vector<Name> name;

    std::span<const Name> of(int tile) const {
        return std::span(name).subspan(first[size_t(tile)], first[size_t(tile) + 1] - first[size_t(tile)]);
    }
    const RibbonPiece& piece(const Name& n) const { return part[n.part][n.index]; }
};

/// In parallel; the same for any number of threads.
TileBins bin_pieces(const HairInView& hair);

}  // namespace tress
