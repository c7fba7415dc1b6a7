// SPDX-License-Identifier: MIT
// Fragments of one tile: taken in any order, given back texel by texel in the order of depth. What lies behind a texel
// that is opaque already is not kept. Quick where ribbons come roughly in the order of depth.
#pragma once

#include <span>
#include <vector>

#include "gather/shadow_maps/hair_fragments.h"
#include "gather/shadow_maps/ribbon_piece.h"

namespace tress {

class FragmentSorter {
public:
    /// Forgets what was there; `channels` 1 or 3.
    void begin(int channels);

    /// Fragments that are added from here on belong to pieces[piece]; at most `most` of them.
    void begin_piece(uint32_t piece, const RibbonPiece& its, size_t most);
    void add(int texel, float coverage, float depth);

    /// `pieces`: all, in the order of segments.
    void finish(std::span<const RibbonPiece> pieces, FragmentTile& tile);

private:
    static constexpr int kTexels = kViewTile * kViewTile;

    struct Fragment {
        float depth;
        uint32_t piece;
        float coverage;
    };
    /// `closed`: what lies deeper is not kept; infinity while `light`, what all fragments so far leave (of the channel
    /// of which least is stopped), is not that of an opaque texel.
    struct Texel {
        float light, deepest, closed;
        uint32_t count;
    };
    void sort(uint32_t first, uint32_t last);
    static bool comes_before(const Fragment& a, const Fragment& b) {
        return a.depth != b.depth ? a.depth < b.depth : a.piece < b.piece;
    }

    int channels_ = 1;
    uint32_t piece_ = 0;
    float least_stopped_ = 0;  // of any channel, by this piece
    size_t added_ = 0;
    std::vector<Texel> texels_;
    std::vector<Fragment> unsorted_, sorted_;
    std::vector<uint16_t> texel_of_;
};

}  // namespace tress
