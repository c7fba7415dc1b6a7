// SPDX-License-Identifier: MIT
// Fragments of one tile: taken in any order, given back texel by texel in the order of depth. What lies behind a texel
// that is opaque already is not kept. Quick where ribbons come roughly in the order of depth.
#pragma once

#include <vector>

#include "gather/shadow_maps/hair_fragments.h"

namespace tress {

class FragmentSorter {
public:
    /// Forgets what was there; `channels` 1 or 3. Pieces are counted in the order of segments. A texel whose light is
    /// below `opaque` is.
    void begin(int channels, size_t pieces, float opaque);

    /// Fragments that are added from here on belong to a piece that stops so much; at most `most` of them.
    void begin_piece(uint32_t piece, const Rgb& stopped, size_t most);
    void add(int texel, float coverage, float depth);

    void finish(FragmentTile& tile);

private:
    static constexpr int kTexels = kViewTile * kViewTile;

    /// In the order of depth, then of pieces, as `order` is: of the depth a number that is larger where it is.
    struct Fragment {
        uint32_t piece, depth;
        float coverage;

        uint64_t order() const { return uint64_t(depth) << 32 | piece; }
    };
    /// `closed`: what lies deeper is not kept; infinity while `light`, what all fragments so far leave (of the channel
    /// of which least is stopped), is not that of an opaque texel.
    struct Texel {
        float light, deepest, closed;
        uint32_t count;
    };
    void sort(uint32_t first, uint32_t last);

    int channels_ = 1;
    float opaque_ = 0;
    uint32_t piece_ = 0;
    float least_stopped_ = 0;  // of any channel, by this piece
    size_t added_ = 0;
    std::vector<Texel> texels_;
    std::vector<Rgb> stopped_;  // by each piece
    std::vector<Fragment> unsorted_, sorted_;
    std::vector<uint16_t> texel_of_;
};

}  // namespace tress
