// SPDX-License-Identifier: MIT
// What of a plot is drawn, and where.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/plot/plot_axis.h"
#include "io/plot/plot_lengths.h"
#include "io/plot/plot_ticks.h"
#include "io/plot/svg_plot.h"

namespace tress::svg {

struct DrawnPoint {
    double x, y, low, high;  // in units; low <= high
    bool is_open;            // the low end is below all of a logarithmic axis
    const std::string* label;
};

struct DrawnSeries {
    const PlotSeries* source;
    std::vector<DrawnPoint> points;
    std::optional<double> floor;  // in units
};

struct Layout {
    Axis x, y;
    bool has_data = false;
    double height = kLeastHeight;
    std::vector<std::u32string> title;
    std::vector<std::vector<std::u32string>> legend;
    std::vector<DrawnSeries> series;
    std::vector<Tick> x_ticks, y_ticks;
};

double legend_height(const std::vector<std::u32string>& lines);
/// `plot` must outlive it.
Layout lay_out(const Plot& plot);

}  // namespace tress::svg
