// SPDX-License-Identifier: MIT
#include "tools/study/methods/method_page.h"

#include <algorithm>
#include <cmath>

#include "core/error_fit.h"
#include "tools/number_text.h"
#include "tools/study/methods/picture_error.h"
#include "tools/study/study_scene.h"

namespace tress {
namespace {

constexpr int kCurvePoints = 48;

const NumberFormat kSeconds{1, 3, " s"}, kTimes{1, 3, "×"}, kMegabytes{1e-6, 3, " MB"}, kPercent{100, 2, " %"},
    kSignedPercent{100, 2, " %", true}, kError{1, 2};

/// "type1" as "Type 1".
std::string layer_title(const std::string& layer) {
    return layer.starts_with("type") ? "Type " + layer.substr(4) : "the whole picture";
}

std::vector<std::string> layers_of(const Json& reference) {
    std::vector<std::string> layers;
    for (const auto& [layer, error] : reference["errors"].items()) layers.push_back(layer);
    return layers;
}

/// A table with a row for each line of `results`.
template <class Cells>
void fill(Table& table, const MethodResults& results, const Cells& cells) {
    for (size_t i = 0; i < results.rows.size(); ++i)
        table.rows.push_back({results.rows[i]["row"], cells("row." + std::to_string(i), results.rows[i])});
}

Table times_table(const MethodResults& results) {
    const std::string spp = std::to_string(results.rows.front()["spp"].get<int>());
    Table t;
    t.id = "times";
    t.heading = "Time, memory and error at equal samples";
    t.caption =
        "Medians over runs; the picture at " + spp +
        " samples a pixel. Build: everything that is made before the first sample. The paper's column is of its "
        "Table 1, of another scene on another machine: how many times as fast as RT / RT / RT. RT ray tracing, DSM "
        "deep shadow maps, P projection, – left out.";
    t.first_column = "Types 1 / 2 / 3";
    t.columns = {{"build", ""},
                 {"render", "to " + spp + " samples a pixel"},
                 {"in all", "build and render"},
                 {"times as fast", "as the first row"},
                 {"in the paper", "times as fast as RT / RT / RT, Table 1"},
                 {"memory", "peak of the process"},
                 {"relMSE", "of the whole picture"},
                 {"FLIP", "HDR-FLIP of the whole picture"},
                 {"mean", "signed: of the picture over the reference's, less 1"}};
    fill(t, results, [](const std::string& line, const Json& row) {
        const auto cell = [&](const char* pointer, const NumberFormat& format) {
            return NumberCell{line, &row, pointer, format};
        };
        return std::vector<NumberCell>{cell("/build_seconds", kSeconds),
                                       cell("/render_seconds", kSeconds),
                                       cell("/total_seconds", kSeconds),
                                       cell("/times_as_fast", kTimes),
                                       cell("/paper_times_as_fast", kTimes),
                                       cell("/peak_rss_bytes", kMegabytes),
                                       cell("/errors/whole/relmse", kError),
                                       cell("/errors/whole/flip", kError),
                                       cell("/layers/whole/signed_mean", kSignedPercent)};
    });
    mark_best(t, 2, true);
    mark_best(t, 6, true);
    return t;
}

Table equals_table(const MethodResults& results) {
    const Json &times = results.rows.front()["equal_time"], &errors = results.rows.front()["equal_error"];
    Table t;
    t.id = "equals";
    t.heading = "Equal time, equal error";
    t.caption =
        "Of the whole picture, by the fits, preparation included. Left: relMSE after so many seconds in all. Right: "
        "seconds in all to a relMSE. Italic: beyond the times that were measured.";
    t.first_column = "Types 1 / 2 / 3";
    t.groups = {{"relMSE after", int(times.size())}, {"seconds to a relMSE of", int(errors.size())}};
    for (const Json& at : times) t.columns.push_back({significant(at["seconds"], 1) + " s", ""});
    for (const Json& at : errors) t.columns.push_back({significant(at["relmse"], 1), ""});
    fill(t, results, [](const std::string& line, const Json& row) {
        std::vector<NumberCell> cells;
        const auto add = [&](const std::string& list, const char* value, const NumberFormat& format,
                             const char* missing) {
            for (size_t k = 0; k < row[list].size(); ++k) {
                NumberCell cell{line, &row, "/" + list + "/" + std::to_string(k) + "/" + value, format, missing};
                cell.beyond = row[list][k]["beyond"];
                cells.push_back(cell);
            }
        };
        add("equal_time", "relmse", kError, "not begun");
        add("equal_error", "seconds", kSeconds, "never");
        return cells;
    });
    for (size_t column = 0; column < t.columns.size(); ++column) mark_best(t, column, true);
    return t;
}

Table bias_table(const MethodResults& results) {
    const std::vector<std::string> layers = layers_of(results.reference);
    Table t;
    t.id = "bias";
    t.heading = "Bias and noise of each type";
    t.caption =
        "relMSE = bias² + c / t over the seconds t of rendering, fitted to all pictures of a row. Bias is what would "
        "be "
        "left after endless time, without the reference's own error; c is the noise, as relMSE times seconds; mean is "
        "the signed difference of the layer's mean from the reference's at the end of the runs. ± is a standard error "
        "over runs. A bias smaller than the root of the reference's error is not known to be one.";
    t.first_column = "Types 1 / 2 / 3";
    for (const std::string& layer : layers) {
        t.groups.push_back({layer_title(layer), 3});
        t.columns.insert(t.columns.end(), {{"bias", ""}, {"c, s", "relMSE × seconds"}, {"mean", "signed"}});
    }
    fill(t, results, [&](const std::string& line, const Json& row) {
        std::vector<NumberCell> cells;
        for (const std::string& layer : layers) {
            const std::string place = "/layers/" + layer + "/";
            cells.push_back({line, &row, place + "bias", kPercent, "left out", place + "bias_error"});
            cells.push_back({line, &row, place + "noise", kError, "–", place + "noise_error"});
            cells.push_back({line, &row, place + "signed_mean", kSignedPercent, "–", place + "signed_mean_error"});
        }
        return cells;
    });
    return t;
}

Table reference_table(const MethodResults& results) {
    const bool enough = results.verdict["reference_is_enough"];
    Table t;
    t.id = "reference";
    t.heading = "The reference";
    t.caption =
        "By paths, in two independent halves, " + grouped(results.reference["spp"].get<unsigned long long>()) +
        " samples a pixel in all, " + duration(results.reference["seconds"]) +
        ". Its own error is a quarter of the relMSE between the halves. " +
        (enough ? "It is at most a tenth of the smallest error shown, in every layer."
                : "<strong>It is more than a tenth of the smallest error shown</strong> where the share below is over "
                  "10 %: errors and biases near it are not trusted. A longer --reference-time makes it smaller.");
    t.first_column = "layer";
    t.columns = {{"its error", "relMSE"}, {"smallest error shown", "relMSE"}, {"share", ""}};
    for (const auto& [layer, unused] : results.verdict["reference"].items()) {
        const std::string place = "/reference/" + layer + "/";
        t.rows.push_back({layer_title(layer),
                          {{"verdict.0", &results.verdict, place + "error", kError},
                           {"verdict.0", &results.verdict, place + "smallest_shown", kError},
                           {"verdict.0", &results.verdict, place + "share", kPercent}}});
    }
    return t;
}

/// Middle, least and largest of a figure over the runs that have so many samples.
std::vector<PlotPoint> points_of(const MeasuredRow& row, double build, const std::string& layer, const char* error) {
    std::vector<PlotPoint> points;
    for (int spp = 1;; spp *= 2) {
        std::vector<double> seconds, values;
        for (const Json& run : row.runs)
            for (const Json& point : run["points"])
                if (point["spp"] == spp && point["errors"].contains(layer)) {
                    seconds.push_back(point["seconds"]);
                    values.push_back(point["errors"][layer][error]);
                }
        if (values.empty()) return points;
        std::sort(seconds.begin(), seconds.end());
        std::sort(values.begin(), values.end());
        const double y = values[values.size() / 2];
        points.push_back({build + seconds[seconds.size() / 2], y, values.front(), values.back(),
                          row.row.name + ": " + std::to_string(spp) + " spp, " + significant(y)});
    }
}

PlotSeries series_of(const MeasuredRow& row, const Json& result, const std::string& layer) {
    PlotSeries series;
    series.name = row.row.name;
    const double build = result["build_seconds"];
    series.points = points_of(row, build, layer, "relmse");
    series.line = false;
    if (!result["layers"].contains(layer) || series.points.empty()) return series;
    const ErrorFit fit{.floor = result["layers"][layer]["floor"], .noise = result["layers"][layer]["noise"]};
    if (fit.floor > 0) series.floor = fit.floor;
    const double first = series.points.front().x - build, last = series.points.back().x - build;
    for (int i = 0; i < kCurvePoints; ++i) {
        const double t = first * std::pow(last / first, double(i) / (kCurvePoints - 1));
        series.curve.emplace_back(build + t, fit.at(t));
    }
    return series;
}

Plot error_plot(const MethodResults& results, const std::vector<MeasuredRow>& rows, const std::string& layer) {
    Plot plot;
    plot.title = "Error of " + layer_title(layer);
    plot.x_label = "seconds, build and render";
    plot.y_label = "relMSE";
    for (size_t i = 0; i < rows.size(); ++i) {
        PlotSeries series = series_of(rows[i], results.rows[i], layer);
        if (!series.points.empty()) plot.series.push_back(std::move(series));
    }
    PlotSeries reference;
    reference.name = "error of the reference";
    reference.floor = results.reference["errors"][layer].get<double>();
    plot.series.push_back(std::move(reference));
    return plot;
}

Plot flip_plot(const MethodResults& results, const std::vector<MeasuredRow>& rows) {
    Plot plot;
    plot.title = "FLIP of the whole picture";
    plot.x_label = "seconds, build and render";
    plot.y_label = "mean HDR-FLIP";
    for (size_t i = 0; i < rows.size(); ++i) {
        PlotSeries series;
        series.name = rows[i].row.name;
        series.points = points_of(rows[i], results.rows[i]["build_seconds"], kWhole, "flip");
        plot.series.push_back(std::move(series));
    }
    return plot;
}

}  // namespace

Page make_method_page(const MethodResults& results, const std::vector<MeasuredRow>& rows) {
    Page page;
    page.title =
        results.header["kind"] == "methods" ? "Methods: error and run time" : "Convergence: error against time";
    page.facts = facts(results.header);
    const bool quick = results.header["quick"];
    const int runs = results.header["runs_a_row"];
    page.facts.push_back(
        (runs == 1 ? "one run a row" : std::to_string(runs) + " runs a row, each with a seed of its own") +
        std::string(quick ? "; a quick study: small pictures, coarse photon and shadow maps" : ""));
    page.verdict = escape_html(results.verdict["text"]);
    page.tables = {times_table(results), equals_table(results), bias_table(results), reference_table(results)};
    for (const std::string& layer : layers_of(results.reference)) {
        page.plots.push_back({error_plot(results, rows, layer), "error-" + layer + ".svg",
                              "Points: middle of the runs, with the range over them. Lines: bias² + c / t. Dashed: "
                              "bias², and the reference's own error. Click a name to hide it."});
    }
    page.plots.push_back({flip_plot(results, rows), "flip-whole.svg", "Below 0.03 two pictures look alike."});
    return page;
}

}  // namespace tress
