// SPDX-License-Identifier: MIT
#include "io/plot/plot_layout.h"

#include <cmath>

#include "io/plot/svg_text.h"

namespace tress::svg {
namespace {

constexpr double kFloorReach = 0.1;  // of the lowest point
constexpr int kMostTicksUp = 8;

std::optional<DrawnPoint> drawn(const Plot& plot, const PlotPoint& p) {
    const auto x = units(plot.log_x, p.x), y = units(plot.log_y, p.y);
    if (!x || !y) return {};
    DrawnPoint point{*x, *y, *y, *y, false, &p.label};
    if (p.low == p.high) return point;
    const auto low = units(plot.log_y, p.low), high = units(plot.log_y, p.high);
    point.low = std::min(low.value_or(*y), high.value_or(*y));
    point.high = std::max(low.value_or(*y), high.value_or(*y));
    point.is_open = plot.log_y && std::isfinite(p.low) && p.low <= 0;
    return point;
}

/// `data`: heights of all points with their ranges, in units.
void keep_near_floors(const Plot& plot, const Range& data, std::vector<DrawnSeries>& all) {
    for (DrawnSeries& series : all) {
        if (!series.source->floor || data.empty()) continue;
        const auto floor = units(plot.log_y, *series.source->floor);
        constexpr double kSlack = 1e-9;
        if (floor && (!plot.log_y || *floor >= data.low + std::log10(kFloorReach) - kSlack)) series.floor = floor;
    }
}

void gather_data(const Plot& plot, Layout& layout) {
    Range across, up;
    for (const PlotSeries& source : plot.series) {
        DrawnSeries series{&source, {}, {}};
        for (const PlotPoint& p : source.points) {
            const auto point = drawn(plot, p);
            if (!point) continue;
            across.add(point->x);
            up.add(point->y);
            up.add(point->low);
            up.add(point->high);
            series.points.push_back(*point);
        }
        layout.series.push_back(std::move(series));
    }
    layout.has_data = !up.empty();
    if (!layout.has_data) return;
    keep_near_floors(plot, up, layout.series);
    for (const DrawnSeries& series : layout.series)
        if (series.floor) up.add(*series.floor);
    layout.x.range = widened(across, plot.log_x);
    layout.y.range = widened(up, plot.log_y);
}

/// Places the plot's four sides, once the legend's height and the ranges are known.
void place_axes(Layout& layout) {
    const double top = 22 + kTitleLine * double(std::max<size_t>(layout.title.size(), 1));
    double legend = 0;
    for (const auto& lines : layout.legend) legend += legend_height(lines);
    layout.height = std::ceil(std::max(kLeastHeight, top + legend + kEdge));
    layout.y.to = top;
    layout.y.from = std::min(layout.height - kBelowPlot, top + kTallestPlot);
    if (layout.has_data) layout.y_ticks = ticks_of(layout.y, kMostTicksUp);
    double widest = 0;
    for (const Tick& tick : layout.y_ticks) widest = std::max(widest, tick.width);
    layout.x.from = std::ceil(std::max(58.0, 34 + widest + kMajorTick));
    layout.x.to = kRight;
    if (layout.has_data) layout.x_ticks = ticks_across(layout.x);
}

}  // namespace

double legend_height(const std::vector<std::u32string>& lines) {
    return double(std::max<size_t>(lines.size(), 1)) * kLegendLine + kLegendGap;
}

Layout lay_out(const Plot& plot) {
    Layout layout;
    layout.x.log = plot.log_x;
    layout.y.log = plot.log_y;
    layout.title = wrapped(plot.title, kWidth - 2 * kEdge, kTitleFont * kBold, kTitleLines);
    for (const PlotSeries& series : plot.series)
        layout.legend.push_back(wrapped(series.name, kWidth - 4 - kLegendText, kFont, kLegendLines));
    gather_data(plot, layout);
    place_axes(layout);
    return layout;
}

}  // namespace tress::svg
