// SPDX-License-Identifier: MIT
#include "tools/study/accel/tree_plots.h"

#include <algorithm>
#include <map>

#include "tools/number_text.h"
#include "tools/study/accel/tree_result.h"

namespace tress {
namespace {

constexpr size_t kFewestPoints = 3;

using Rows = std::vector<const Json*>;

PlotPoint point_of(const Json& row, const std::string& set, double x) {
    const Json& rays = row["rays"][set];
    const double y = rays["mrays_per_second"];
    return {x, y, rays["lowest"], rays["highest"],
            row["row"].get<std::string>() + ": " + significant(y) + " million " + set + " rays/s"};
}

template <class Cost>
PagePlot cost_plot(const Rows& rows, const std::vector<std::string>& sets, const Cost& cost, const char* title,
                   const char* file, const char* caption) {
    Plot plot;
    plot.title = title;
    plot.x_label = "cost a ray, tests of a segment";
    plot.y_label = "million rays a second";
    for (const std::string& set : sets) {
        PlotSeries series{set};
        series.line = false;
        for (const Json* row : rows) series.points.push_back(point_of(*row, set, cost(*row, set)));
        plot.series.push_back(std::move(series));
    }
    return {plot, file, caption};
}

/// Rows that are alike but for one option, whose values are numbers, in the order of these.
using Line = std::map<double, const Json*>;

std::vector<Line> lines_along(const Rows& rows, const std::string& key) {
    std::map<std::string, Line> lines;  // by all other options
    for (const Json* row : rows) {
        Json others = (*row)["accel"];
        const std::string text = others[key];
        others.erase(key);
        size_t read = 0;
        try {
            const double value = std::stod(text, &read);
            if (read == text.size()) lines[others.dump()].emplace(value, row);
        } catch (const std::invalid_argument&) {  // a word
        }
    }
    std::vector<Line> long_enough;
    for (auto& [others, line] : lines)
        if (line.size() >= kFewestPoints) long_enough.push_back(std::move(line));
    return long_enough;
}

/// What a line's rows have in common, told from other lines.
std::string name_of(const Line& line, const std::string& key) {
    std::string name;
    for (const auto& setting : (*line.begin()->second)["settings"]) {
        const std::string text = setting;
        if (text.starts_with(key + "=")) continue;
        name += ", " + text.substr(text.find('.') + 1);
    }
    return name;
}

PagePlot option_plot(const std::vector<Line>& lines, const std::vector<std::string>& sets, const std::string& key) {
    Plot plot;
    plot.title = "Rays a second by " + key;
    plot.x_label = key;
    plot.y_label = "million rays a second";
    plot.log_x = true;
    for (const Line& line : lines) {
        plot.log_x = plot.log_x && line.begin()->first > 0;
        for (const std::string& set : sets) {
            PlotSeries series{set + name_of(line, key)};
            for (const auto& [value, row] : line) series.points.push_back(point_of(*row, set, value));
            plot.series.push_back(std::move(series));
        }
    }
    return {plot, key + ".svg", "Other options are the same along a line. Bars: range over the rounds."};
}

}  // namespace

std::vector<PagePlot> tree_plots(const std::vector<Json>& all) {
    Rows rows;
    for (const Json& row : all)
        if (row.contains("rays") && !row["rays"].empty()) rows.push_back(&row);
    if (rows.empty()) return {};
    const std::vector<std::string> sets = ray_sets(all);
    std::vector<PagePlot> plots{
        cost_plot(
            rows, sets, [](const Json& row, const std::string&) { return row["sah_cost"].get<double>(); },
            "Speed by the cost predicted", "predicted.svg",
            "What the surface area heuristic expects of a ray that nothing stops, steps at the scene's own "
            "accel.traversal_cost. A tree a point."),
        cost_plot(
            rows, sets, [](const Json& row, const std::string& set) { return row["rays"][set]["cost"].get<double>(); },
            "Speed by the cost counted", "counted.svg", "Of the steps and tests that these rays did. A tree a point.")};
    for (const auto& [key, unused] : rows.front()->at("accel").items())
        if (const std::vector<Line> lines = lines_along(rows, key); !lines.empty())
            plots.push_back(option_plot(lines, sets, key));
    return plots;
}

}  // namespace tress
