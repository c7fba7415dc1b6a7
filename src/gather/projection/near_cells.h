// SPDX-License-Identifier: MIT
// What hair next to a point lets through in each cell. Such a segment is as wide as a good part of a cell, and hides
// another or leaves a gap beside it: a product over segments, as if each lay anywhere in the cell, would be wrong
// either way, and for all turns of the cells alike. So the samples of a cell count how many segments lie one behind
// another. All of a cell's count with their mean opacity; one that covers no sample counts for nothing where there are
// others, as one that covers a sample counts for more than itself: on average over samples that is right.
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
    static constexpr int kPlanes = 4;

    float stopped[3] = {};           // share of the cell's light, by solid angles, summed over segments
    uint32_t segment = kNone;        // the one that is there, or kSeveral
    Rgbx sampled;                    // as `stopped`, by samples; [3]: share of the samples, whatever the opacity
    uint64_t covered[kPlanes] = {};  // how many segments cover each sample, at most 15: a bit of that number each

    /// Another piece of a segment, that stops a share of the light, but for its opacity, and covers the samples whose
    /// bits are set.
    void add(uint32_t of_segment, float share, uint64_t samples, const Rgbx& opacity) {
        const float sampled_share = float(std::popcount(samples)) / 64;
        for (int c = 0; c < 3; ++c) {
            stopped[c] += share * opacity.c[c];
            sampled.c[c] += sampled_share * opacity.c[c];
        }
        sampled.c[3] += sampled_share;
        for (uint64_t& plane : covered) {
            const uint64_t carried = plane & samples;
            plane ^= samples;
            samples = carried;
        }
        for (uint64_t& plane : covered) plane |= samples;
        segment = segment == kNone || segment == of_segment ? of_segment : kSeveral;
    }

    /// Of a single segment, by its solid angle. Of several, the mean over samples of what their number lets through.
    Rgbx transmittance() const {
        Rgbx through;
        if (segment != kSeveral) {
            for (int c = 0; c < 3; ++c) through.c[c] = std::max(1 - stopped[c], 0.0f);
            return through;
        }
        float one[3], all[3] = {1, 1, 1};  // what one segment lets through, and as many as are counted
        for (int c = 0; c < 3; ++c) one[c] = std::max(1 - sampled.c[c] / std::max(sampled.c[3], 1e-30f), 0.0f);
        int planes = kPlanes;
        while (planes > 0 && covered[planes - 1] == 0) --planes;
        for (int count = 0; count < 1 << planes; ++count) {
            uint64_t with = ~uint64_t(0);
            for (int plane = 0; plane < planes; ++plane) with &= count >> plane & 1 ? covered[plane] : ~covered[plane];
            const float share = float(std::popcount(with)) / 64;
            for (int c = 0; c < 3; ++c) {
                through.c[c] += share * all[c];
                all[c] *= one[c];
            }
        }
        return through;
    }
};

/// Cells of a dome; those of hair behind polygons follow, where there are polygons.
struct NearCells {
    std::vector<NearCell> cells;

    void clear(size_t count) { cells.assign(count, NearCell{}); }

    /// Of one of `of_dome` cells; in sight: that is before polygons.
    Rgbx through(size_t cell, size_t of_dome, bool in_sight) const {
        Rgbx t = cells[cell].transmittance();
        if (in_sight || cells.size() == of_dome) return t;
        const Rgbx behind = cells[of_dome + cell].transmittance();
        for (int c = 0; c < 3; ++c) t.c[c] *= behind.c[c];
        return t;
    }
};

}  // namespace tress
