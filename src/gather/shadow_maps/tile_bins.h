// SPDX-License-Identifier: MIT
// Which segments may be in which tile of a view: all that are, and few others.
#pragma once

#include <span>
#include <vector>

#include "core/segments.h"
#include "gather/shadow_maps/light_view.h"

namespace tress {

struct TileBins {
    std::vector<uint64_t> first;    // tile t holds segment[first[t]] .. segment[first[t + 1] - 1]
    std::vector<uint32_t> segment;  // of each tile in their order

    std::span<const uint32_t> of(int tile) const {
        return std::span(segment).subspan(first[size_t(tile)], first[size_t(tile) + 1] - first[size_t(tile)]);
    }
};

/// In parallel; the same for any number of threads.
TileBins bin_segments(const LightView& view, const SegmentView& segments);

}  // namespace tress
