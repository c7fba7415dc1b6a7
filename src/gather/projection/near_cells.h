// SPDX-License-Identifier: MIT
// What hair next to a point lets through in each cell. Such a fiber is as wide as a good part of a cell, and hides
// another or leaves a gap beside it: a product over fibers, as if each lay anywhere in the cell, would be wrong either
// way, and for all turns of the cells alike. So the samples of a cell count how many fibers lie one behind another.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gather/projection/hair_opacity.h"

namespace tress {

struct NearCell {
    static constexpr uint32_t kNone = UINT32_MAX, kSeveral = UINT32_MAX - 1;
    static constexpr int kPlanes = 3;

    Rgbx stopped;                    // share of the cell's light, by solid angles, summed over fibers
    Rgbx sampled;                    // the same by samples; [3]: share of the samples, whatever the opacity
    uint64_t covered[kPlanes] = {};  // how many pieces of hair cover each sample, at most 7: a bit of that number each
    uint32_t segment = kNone;        // whose pieces these are: one, or kSeveral

    /// Another piece, that of its samples covers those whose bits are set.
    void add(uint32_t of_segment, uint64_t samples, const Rgbx& opacity) {
        const float share = float(std::popcount(samples)) / 64;
        for (int c = 0; c < 3; ++c) sampled.c[c] += share * opacity.c[c];
        sampled.c[3] += share;
        for (uint64_t& plane : covered) {
            const uint64_t carried = plane & samples;
            plane ^= samples;
            samples = carried;
        }
        for (uint64_t& plane : covered) plane |= samples;
        segment = segment == kNone || segment == of_segment ? of_segment : kSeveral;
    }

    void stop(float share, const Rgbx& opacity) {
        for (int c = 0; c < 3; ++c) stopped.c[c] += share * opacity.c[c];
    }

    /// Of a single fiber, by its solid angle. Of several, the mean over samples of what their number lets through, each
    /// with the mean opacity.
    Rgbx transmittance() const {
        Rgbx through;
        if (segment != kSeveral) {
            for (int c = 0; c < 3; ++c) through.c[c] = std::max(1 - stopped.c[c], 0.0f);
            return through;
        }
        float one[3], all[3] = {1, 1, 1};  // what one fiber lets through, and as many as are counted
        for (int c = 0; c < 3; ++c) one[c] = std::max(1 - sampled.c[c] / std::max(sampled.c[3], 1e-30f), 0.0f);
        for (int count = 0; count < 1 << kPlanes; ++count) {
            uint64_t with = ~uint64_t(0);
            for (int plane = 0; plane < kPlanes; ++plane) with &= count >> plane & 1 ? covered[plane] : ~covered[plane];
            const float share = float(std::popcount(with)) / 64;
            for (int c = 0; c < 3; ++c) {
                through.c[c] += share * all[c];
                all[c] *= one[c];
            }
        }
        return through;
    }
};

/// Cells of a dome. Those of hair behind polygons follow, where there are polygons: of these only `stopped` counts.
struct NearCells {
    std::vector<NearCell> cells;

    void clear(size_t count) { cells.assign(count, NearCell{}); }

    /// Of one of `of_dome` cells; in sight: that is before polygons.
    Rgbx through(size_t cell, size_t of_dome, bool in_sight) const {
        Rgbx t = cells[cell].transmittance();
        if (!in_sight && cells.size() > of_dome)
            for (int c = 0; c < 3; ++c) t.c[c] *= std::max(1 - cells[of_dome + cell].stopped.c[c], 0.0f);
        return t;
    }
};

}  // namespace tress
