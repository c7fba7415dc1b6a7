// SPDX-License-Identifier: MIT
// Line plots as SVG: logarithmic or linear axes, error bars, fitted curves, floors and a legend.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tress {

/// A point with the range it spreads over (low = high = y: none). An end of the range that is not finite is left out.
struct PlotPoint {
    double x = 0, y = 0;
    double low = y, high = y;
    std::string label = {};  ///< shown on hover
};

struct PlotSeries {
    std::string name;
    std::vector<PlotPoint> points = {};
    bool line = true;                  ///< joined in the order given; otherwise markers alone
    std::optional<double> floor = {};  ///< drawn as a dashed level line at y = floor, over the whole width of the plot
    std::vector<std::pair<double, double>> curve = {};  ///< an additional thin line (a fitted model), may be empty
};

struct Plot {
    std::string title, x_label, y_label;
    bool log_x = true, log_y = true;
    std::vector<PlotSeries> series = {};
};

/// The plot as one whole SVG document, readable on light and dark ground and in print. It may stand alone or be put
/// into an HTML page as it is, any number of times: it has no ids and its style rules reach elements of class "plot"
/// alone. Series K is a group of class "series" with data-series="K", its legend entry one of class "legend"; class
/// "off" hides the one and dims the other.
///
/// The axes span the points with their ranges, and the floors; curves are clipped. What is not finite is left out, on
/// a logarithmic axis also what is not positive, there also a floor below a tenth of all points (the low end of a range
/// is clipped instead). The same plot gives the same bytes, whatever the locale.
std::string svg_plot(const Plot& plot);

}  // namespace tress
