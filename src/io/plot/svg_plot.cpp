// SPDX-License-Identifier: MIT
// A plot is laid out (legend, ranges, ticks), then written from back to front.
#include "io/plot/svg_plot.h"

#include <algorithm>

#include "io/plot/plot_layout.h"
#include "io/plot/plot_lengths.h"
#include "io/plot/plot_style.h"
#include "io/plot/svg_text.h"

namespace tress {
namespace svg {
namespace {

std::string one_line(const std::string& text, double width) {
    const auto lines = wrapped(text, width, kFont, 1);
    return lines.empty() ? std::string() : escaped(lines.front());
}

std::string series_class(size_t k) { return 's' + std::to_string(k % kColors); }

/// Past the first eight series lines are dashed ...
std::string line_class(size_t k) {
    constexpr size_t kDashes = 4;
    const size_t dash = k / kColors % kDashes;
    return dash == 0 ? "line" : "line d" + std::to_string(dash);
}

/// ... and every other eight have hollow markers.
std::string mark(size_t k, double x, double y, const std::string& title) {
    const bool hollow = k / kColors % 2 == 1;
    const std::string start = "<path class=\"" + std::string(hollow ? "mark hollow" : "mark") +
                              "\" transform=\"translate(" + point(x, y) + ")\" d=\"" + kMarks[k % kColors] + '"';
    return start + (title.empty() ? "/>\n" : "><title>" + title + "</title></path>\n");
}

std::string axis_lines(const Layout& layout) {
    const Axis &x = layout.x, &y = layout.y;
    std::string grid, lines = 'M' + point(x.from, y.to) + 'V' + coord(y.from) + 'H' + coord(x.to);
    for (const Tick& tick : layout.x_ticks) {
        const double at = x.at(tick.at);
        if (tick.major()) grid += 'M' + point(at, y.to) + 'V' + coord(y.from);
        lines += 'M' + point(at, y.from) + 'v' + coord(tick.major() ? kMajorTick : kMinorTick);
    }
    for (const Tick& tick : layout.y_ticks) {
        const double at = y.at(tick.at);
        if (tick.major()) grid += 'M' + point(x.from, at) + 'H' + coord(x.to);
        lines += 'M' + point(x.from, at) + 'h' + coord(tick.major() ? -kMajorTick : -kMinorTick);
    }
    return path("grid", grid) + path("axis", lines);
}

std::string tick_labels(const Layout& layout) {
    std::string out;
    for (const Tick& tick : layout.x_ticks)
        if (tick.major())
            out += text_at(layout.x.at(tick.at), layout.y.from + 18, "tick", tick.label, " text-anchor=\"middle\"");
    for (const Tick& tick : layout.y_ticks)
        if (tick.major())
            out += text_at(layout.x.from - 8, layout.y.at(tick.at) + 4, "tick", tick.label, " text-anchor=\"end\"");
    return out;
}

std::string titles(const Plot& plot, const Layout& layout) {
    std::string out;
    for (size_t i = 0; i < layout.title.size(); ++i)
        out += text_at(kEdge, 24 + kTitleLine * double(i), "title", escaped(layout.title[i]));
    const double across = layout.x.to - layout.x.from, up = layout.y.from - layout.y.to;
    out += text_at(layout.x.from + across / 2, layout.y.from + 38, "name", one_line(plot.x_label, across),
                   " text-anchor=\"middle\"");
    const double x = 17, y = layout.y.to + up / 2;
    out += text_at(x, y, "name", one_line(plot.y_label, up),
                   " text-anchor=\"middle\" transform=\"rotate(-90 " + point(x, y) + ")\"");
    return out;
}

struct Position {
    double x, y;
};

/// The part of the straight line a-b inside the plot: between which fractions of its length (Liang and Barsky).
std::optional<std::pair<double, double>> inside(const Layout& layout, const Position& a, const Position& b) {
    double from = 0, to = 1;
    const auto keep = [&](double start, double change, double least, double most) {
        if (change == 0) return start >= least && start <= most;
        const double t = (least - start) / change, u = (most - start) / change;
        from = std::max(from, std::min(t, u));
        to = std::min(to, std::max(t, u));
        return from <= to;
    };
    if (!keep(a.x, b.x - a.x, layout.x.from, layout.x.to)) return {};
    if (!keep(a.y, b.y - a.y, layout.y.to, layout.y.from)) return {};
    return std::pair(from, to);
}

/// Far positions are brought nearer, still out of sight.
Position position(const Layout& layout, double x, double y) {
    constexpr double kFar = 1e9;
    return {std::clamp(layout.x.at(x), -kFar, kFar), std::clamp(layout.y.at(y), -kFar, kFar)};
}

std::string curve_path(const Plot& plot, const Layout& layout, const PlotSeries& series) {
    std::string d;
    std::optional<Position> last;
    bool joined = false;  // `last` is the end of the path
    for (const auto& [x_value, y_value] : series.curve) {
        const auto x = units(plot.log_x, x_value), y = units(plot.log_y, y_value);
        const auto here = x && y ? std::optional(position(layout, *x, *y)) : std::nullopt;
        const auto part = last && here ? inside(layout, *last, *here) : std::nullopt;
        const auto along = [&](double t) {
            return point(last->x + t * (here->x - last->x), last->y + t * (here->y - last->y));
        };
        if (part) d += (joined ? "L" : 'M' + along(part->first) + 'L') + along(part->second);
        joined = part.has_value() && part->second == 1;
        last = here;
    }
    return d.empty() ? d : path("curve", d);
}

std::string bar_path(const Layout& layout, const DrawnSeries& series) {
    std::string d;
    const auto cap = [&](double x, double y) { return 'M' + point(x - kCap, y) + 'h' + coord(2 * kCap); };
    for (const DrawnPoint& p : series.points) {
        if (p.low == p.high && !p.is_open) continue;
        const double x = layout.x.at(p.x), high = layout.y.at(p.high);
        const double low = p.is_open ? layout.y.from : layout.y.at(p.low);
        d += 'M' + point(x, low) + 'V' + coord(high);
        if (!p.is_open) d += cap(x, low);
        if (p.high > p.y || p.low > p.y) d += cap(x, high);
    }
    return d.empty() ? d : path("bar", d);
}

std::string line_path(const Layout& layout, const DrawnSeries& series, size_t k) {
    if (!series.source->line || series.points.size() < 2) return {};
    std::string d;
    for (const DrawnPoint& p : series.points) d += (d.empty() ? 'M' : 'L') + point(layout.x.at(p.x), layout.y.at(p.y));
    return path(line_class(k).c_str(), d);
}

std::string draw_series(const Plot& plot, const Layout& layout, size_t k) {
    const DrawnSeries& series = layout.series[k];
    std::string out = "<g class=\"series " + series_class(k) + "\" data-series=\"" + std::to_string(k) + "\">\n";
    if (series.floor)
        out += path("floor", 'M' + point(layout.x.from, layout.y.at(*series.floor)) + 'H' + coord(layout.x.to));
    if (layout.has_data) out += curve_path(plot, layout, *series.source);
    out += bar_path(layout, series) + line_path(layout, series, k);
    for (const DrawnPoint& p : series.points) out += mark(k, layout.x.at(p.x), layout.y.at(p.y), escaped(*p.label));
    return out + "</g>\n";
}

std::string sample(const PlotSeries& series, size_t k, double y) {
    const std::string d = 'M' + point(kLegendLeft, y) + 'h' + coord(kSample);
    const bool is_model = !series.line && series.points.empty() && !series.curve.empty();
    const std::string stroke = is_model ? path("curve", d) : series.line ? path(line_class(k).c_str(), d) : "";
    return is_model ? stroke : stroke + mark(k, kLegendLeft + kSample / 2, y, "");
}

std::string legend_entry(const Plot& plot, const Layout& layout, size_t k, double top) {
    const PlotSeries& series = plot.series[k];
    const double height = legend_height(layout.legend[k]);
    std::string out = "<g class=\"legend " + series_class(k) + "\" data-series=\"" + std::to_string(k) +
                      "\" tabindex=\"0\" role=\"button\">\n<title>" + escaped(series.name) +
                      "</title>\n<rect class=\"hit\" x=\"" + coord(kLegendLeft - 4) + "\" y=\"" + coord(top) +
                      "\" width=\"" + coord(kWidth - kLegendLeft + 2) + "\" height=\"" + coord(height) + "\"/>\n";
    out += sample(series, k, top + (kLegendGap + kLegendLine) / 2);
    for (size_t i = 0; i < layout.legend[k].size(); ++i)
        out += text_at(kLegendText, top + kLegendGap / 2 + 10 + kLegendLine * double(i), "name",
                       escaped(layout.legend[k][i]));
    return out + "</g>\n";
}

std::string legend(const Plot& plot, const Layout& layout) {
    std::string out;
    double top = layout.y.to - kLegendGap / 2;
    for (size_t k = 0; k < plot.series.size(); ++k) {
        out += legend_entry(plot, layout, k, top);
        top += legend_height(layout.legend[k]);
    }
    return out;
}

std::string document(const Plot& plot) {
    const Layout layout = lay_out(plot);
    const std::string width = coord(kWidth), height = coord(layout.height);
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + width + ' ' + height +
                      "\" class=\"plot\" role=\"group\" aria-label=\"" + escaped(plot.title) + "\">\n" + style() +
                      "<rect class=\"ground\" width=\"" + width + "\" height=\"" + height + "\"/>\n";
    out += axis_lines(layout) + tick_labels(layout) + titles(plot, layout);
    for (size_t k = 0; k < plot.series.size(); ++k) out += draw_series(plot, layout, k);
    if (!layout.has_data)
        out += text_at((layout.x.from + layout.x.to) / 2, (layout.y.from + layout.y.to) / 2, "empty", "no data",
                       " text-anchor=\"middle\"");
    return out + legend(plot, layout) + "</svg>\n";
}

}  // namespace
}  // namespace svg

std::string svg_plot(const Plot& plot) { return svg::document(plot); }

}  // namespace tress
