// SPDX-License-Identifier: MIT
// Which segments may cover texels of which tile of a view.
#pragma once

#include <span>
#include <vector>

#include "core/segments.h"
#include "gather/shadow_maps/light_view.h"

namespace tress {

/// A segment in a tile.
struct BinnedSegment {
    uint32_t segment;
    float z;  // of the middle of its axis, roughly
};

/// Tile t holds binned[first[t]] .. binned[first[t + 1] - 1], in the order of segments.
struct TileBins {
    std::vector<uint64_t> first;
    std::vector<BinnedSegment> binned;

    std::span<const BinnedSegment> of(int tile) const {
        return std::span(binned).subspan(first[size_t(tile)], first[size_t(tile) + 1] - first[size_t(tile)]);
    }
};

/// In parallel; the same for any number of threads.
TileBins bin_segments(const LightView& view, const SegmentView& segments);

}  // namespace tress
