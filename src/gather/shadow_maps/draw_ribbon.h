// SPDX-License-Identifier: MIT
// How much of each texel a ribbon covers. `take(x, y, coverage, z)` is called once for each texel of a rectangle that
// it covers some of; z is that of the axis, the mean over the texel's part of it.
#pragma once

#include <algorithm>
#include <cmath>

#include "gather/shadow_maps/outline_row.h"
#include "gather/shadow_maps/ribbon.h"

namespace tress {

/// The part of a thin ribbon in one column of texels (across its major axis): a parallelogram about (middle, center),
/// that runs along the column by `rise` from its middle to either side.
struct RibbonColumn {
    double length, center, half_width, slope, rise;  // texels; slope >= 0, for which the rows may be mirrored

    double area() const { return 2 * half_width * length; }

    /// Its area in rows up to `row`: the mean over the column of how much of the width lies below, times its length.
    double area_below(double row) const {
        const double from = row - center + half_width, width = 2 * half_width;
        // Where the column hardly rises the difference of the integrals would be rounding.
        constexpr double kFlat = 0x1p-12;
        if (rise < kFlat * width || rise < kFlat * kFlat) return length * std::clamp(from, 0.0, width);
        return (clamped_integral(from + rise, width) - clamped_integral(from - rise, width)) / slope;
    }
};

/// A thin ribbon in columns [first, last) of its major axis, of which all lie in the rectangle.
template <class Take>
void draw_thin(const LightView& view, const Ribbon& r, const TexelRect& rect, int first, int last, const Take& take) {
    const int major = r.major, minor = 1 - major;
    const double start = r.at[0][major], scale = 1 / (r.at[1][major] - start);
    const double rise = r.at[1][minor] - r.at[0][minor], slope = rise * scale;
    const double z_slope = (r.z[1] - r.z[0]) * scale;
    double low = std::max(start, double(first));
    double z_low = z_at(view, r, (low - start) * scale);
    for (int i = first; i < last; ++i) {
        const double high = std::min(r.at[1][major], double(i + 1));
        const double middle = 0.5 * (low + high), place = (middle - start) * scale;
        RibbonColumn column;
        column.length = high - low;
        column.center = r.at[0][minor] + place * rise;
        column.half_width = r.half_width[0] + place * (r.half_width[1] - r.half_width[0]);
        column.slope = std::abs(slope);
        column.rise = 0.5 * column.length * column.slope;
        const double z_high = view.parallel ? z_low + z_slope * column.length : z_at(view, r, (high - start) * scale);

        const double reach = column.rise + column.half_width;
        const double bottom = std::max(column.center - reach, double(rect.low[minor]));
        const double top = std::min(column.center + reach, double(rect.high[minor]));
        if (bottom < top && column.length > 0) {
            // Where the axis is, row by row: the ribbon rises from end to end of the column.
            const double z_middle = 0.5 * (z_low + z_high);
            const double z_per_row = (slope < 0 ? -0.5 : 0.5) * (z_high - z_low) / reach;
            double below = bottom > column.center - reach ? column.area_below(bottom) : 0;
            for (int j = int(bottom); j < top; ++j) {
                const bool whole = column.center + reach <= j + 1;
                const double up_to = whole ? column.area() : column.area_below(j + 1);
                const double row_middle = 0.5 * (std::max(bottom, double(j)) + std::min(top, double(j + 1)));
                const double z = z_middle + (row_middle - column.center) * z_per_row;
                if (up_to > below) take(major == 0 ? i : j, major == 0 ? j : i, up_to - below, z);
                below = up_to;
            }
        }
        low = high, z_low = z_high;
    }
}

/// A ribbon of any width, or a dot, in a rectangle: the exact area of the outline in each texel.
template <class Take>
void draw_outline(const LightView& view, const Ribbon& r, const RibbonOutline& outline, const TexelRect& rect,
                  const Take& take) {
    const glm::dvec2 axis = r.at[1] - r.at[0];
    const double per_axis = r.shape == Ribbon::Shape::dot ? 0 : 1 / dot(axis, axis);
    const double at_dot = r.shape == Ribbon::Shape::dot ? 0.5 : 0;
    for (int y = rect.low.y; y < rect.high.y; ++y) {
        const OutlineRow row(outline, y);
        const int last = row.last(rect.high.x);
        for (int x = row.first(rect.low.x); x < last; ++x) {
            const double coverage = row.coverage(x);
            if (!(coverage > 0)) continue;
            const glm::dvec2 from_start = glm::dvec2(x + 0.5, y + 0.5) - r.at[0];
            const double place = at_dot + std::clamp(dot(from_start, axis) * per_axis, 0.0, 1.0);
            take(x, y, coverage, z_at(view, r, place));
        }
    }
}

}  // namespace tress
