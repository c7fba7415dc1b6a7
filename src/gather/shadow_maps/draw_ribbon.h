// SPDX-License-Identifier: MIT
// How much of each texel of a tile a ribbon covers. `take(texel, coverage, depth)` is called once for each texel that
// it covers some of, counted row by row from the tile's corner; depth is that of the axis, the mean over the texel's
// part of it.
#pragma once

#include <algorithm>
#include <cmath>

#include "gather/shadow_maps/outline_row.h"
#include "gather/shadow_maps/ribbon_piece.h"

namespace tress {

/// The part of a thin ribbon in one column of texels (across its major axis): a parallelogram, whose middle moves along
/// the column by `rise` to either side. Texels.
struct RibbonColumn {
    float length, center, half_width, rise;
    float per_slope;  // 1 / |slope|

    float area() const { return 2 * half_width * length; }

    /// Its area in rows up to `row`: the mean over the column of how much of the width lies below, times its length.
    float area_below(float row) const {
        const float from = row - center + half_width, width = 2 * half_width;
        // A column that hardly rises: the difference of the integrals, of a texel each, would be rounding.
        constexpr float kFlat = 0x1p-11f;
        if (rise < kFlat) return length * std::clamp(from, 0.0f, width);
        return (clamped_integral(from + rise, width) - clamped_integral(from - rise, width)) * per_slope;
    }
};

/// `rows`: texels of the tile along the piece's minor axis that are in the view.
template <class Take>
void draw_thin(const RibbonPiece& p, int rows, const Take& take) {
    const float scale = p.high > p.low ? 1 / (p.high - p.low) : 0, limit = float(rows);
    const int across = p.major == 0 ? 1 : kViewTile, along = p.major == 0 ? kViewTile : 1;
    RibbonColumn column;
    column.per_slope = 1 / std::abs(p.slope);  // infinity: never asked
    float low = p.low, depth_low = p.depth;
    for (int i = int(p.low); float(i) < p.high; ++i) {
        const float high = std::min(p.high, float(i + 1));
        const float u = (high - p.low) * scale;
        const float depth_high = p.depth + p.deepening * u / (p.bend + u * (1 - p.bend));  // 1 / z is linear
        const float from_start = 0.5f * (low + high) - p.low;
        column.length = high - low;
        column.center = p.center + from_start * p.slope;
        column.half_width = p.half_width + from_start * p.widening;
        column.rise = 0.5f * column.length * std::abs(p.slope);

        const float reach = column.rise + column.half_width;
        const float bottom = column.center - reach, top = column.center + reach;
        const float depth_middle = 0.5f * (depth_low + depth_high);
        const auto put = [&](int j, float coverage, float depth) {
            if (coverage > 0) take(i * across + j * along, coverage, depth);
        };
        if (top > 0 && bottom < limit) {
            const int first = int(std::max(bottom, 0.0f));
            if (bottom >= 0 && top <= float(first + 1)) {
                put(first, column.area(), depth_middle);
            } else {
                // Where the axis is, row by row: the ribbon rises from end to end of the column.
                const float per_row = (p.slope < 0 ? -0.5f : 0.5f) * (depth_high - depth_low) / reach;
                float below = bottom < 0 ? column.area_below(0) : 0;
                for (int j = first; j < rows && float(j) < top; ++j) {
                    const float up_to = top <= float(j + 1) ? column.area() : column.area_below(float(j + 1));
                    const float middle = 0.5f * (std::max(bottom, float(j)) + std::min(top, float(j + 1)));
                    put(j, up_to - below, depth_middle + (middle - column.center) * per_row);
                    below = up_to;
                }
            }
        }
        low = high, depth_low = depth_high;
    }
}

/// A ribbon of any width, or a dot, in texels of the tile whose first is `corner`: the exact area of the outline.
template <class Take>
void draw_outline(const LightView& view, const Ribbon& r, const RibbonOutline& outline, const glm::ivec2& corner,
                  const TexelRect& rect, const Take& take) {
    const glm::dvec2 axis = r.at[1] - r.at[0];
    const bool dot_only = r.shape == Ribbon::Shape::dot;
    const double per_axis = dot_only ? 0 : 1 / dot(axis, axis);
    for (int y = rect.low.y; y < rect.high.y; ++y) {
        const OutlineRow row(outline, y);
        const int last = row.last(rect.high.x);
        for (int x = row.first(rect.low.x); x < last; ++x) {
            const double coverage = row.coverage(x);
            if (!(coverage > 0)) continue;
            const glm::dvec2 from_start = glm::dvec2(x + 0.5, y + 0.5) - r.at[0];
            const double place = dot_only ? 0.5 : std::clamp(dot(from_start, axis) * per_axis, 0.0, 1.0);
            take((y - corner.y) * kViewTile + x - corner.x, float(coverage), float(z_at(view, r, place) - view.start));
        }
    }
}

}  // namespace tress
