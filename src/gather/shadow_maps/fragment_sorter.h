// SPDX-License-Identifier: MIT
// Fragments of one tile: taken in any order, given back texel by texel in the order of depth. What lies behind a texel
// that is opaque already is not kept. Quick where ribbons come roughly in the order of depth.
#pragma once

#include <vector>

#include "gather/shadow_maps/hair_fragments.h"

namespace tress {

/// A stretch of one ribbon along which it lets through the same.
struct RibbonPiece {
    uint32_t segment;
    Rgb stopped;  // 1 - a; one channel where no fiber colours light
};

class FragmentSorter {
public:
    /// Forgets what was there; `channels` 1 or 3.
    void begin(int channels);

    /// Fragments that are added from here on belong to this piece; at most `most` of them.
    void begin_piece(const RibbonPiece& piece, size_t most);
    void add(int texel, float coverage, float depth);

    void finish(FragmentTile& tile);

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
    bool comes_before(const Fragment& a, const Fragment& b) const {
        return a.depth != b.depth ? a.depth < b.depth : pieces_[a.piece].segment < pieces_[b.piece].segment;
    }

    int channels_ = 1;
    float least_stopped_ = 0;
    size_t added_ = 0;
    std::vector<Texel> texels_;
    std::vector<RibbonPiece> pieces_;
    std::vector<Fragment> unsorted_, sorted_;
    std::vector<uint16_t> texel_of_;
};

}  // namespace tress
