// SPDX-License-Identifier: MIT
#include "tools/study/methods/row_result.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/error_fit.h"
#include "tools/comparison.h"
#include "tools/study/median.h"
#include "tools/study/methods/picture_error.h"

namespace tress {
namespace {

constexpr int kLevels = 4;  // of time, and of error, in the tables of equals

template <class Of>
double median_of(const std::vector<Json>& runs, const Of& of) {
    std::vector<double> values;
    for (const Json& run : runs) values.push_back(of(run));
    return median(values);
}

struct Mean {
    double value = 0, error = 0;  // standard
};
Mean mean(const std::vector<double>& values) {
    Mean m;
    const double n = double(values.size());
    for (double v : values) m.value += v / n;
    for (double v : values) m.error += (v - m.value) * (v - m.value);
    m.error = n > 1 ? std::sqrt(m.error / (n * (n - 1))) : 0;
    return m;
}

const Json* point_at(const Json& run, int spp) {
    for (const Json& point : run["points"])
        if (point["spp"] == spp) return &point;
    return nullptr;
}

/// The largest power of two of samples that every run has reached.
int common_spp(const std::vector<MeasuredRow>& rows) {
    int spp = std::numeric_limits<int>::max();
    for (const MeasuredRow& row : rows)
        for (const Json& run : row.runs)
            if (!run["points"].empty()) spp = std::min(spp, run["points"].back()["spp"].get<int>());
    return spp;
}

std::vector<ErrorRun> error_runs(const MeasuredRow& row, const std::string& layer) {
    std::vector<ErrorRun> runs;
    for (const Json& run : row.runs) {
        ErrorRun points;
        for (const Json& point : run["points"])
            if (point["errors"].contains(layer)) points.push_back({point["seconds"], point["errors"][layer]["relmse"]});
        runs.push_back(std::move(points));
    }
    return runs;
}

/// A fit without the error that the reference brings in.
ErrorFit without_reference(ErrorFit fit, double reference_error) {
    fit.floor = std::max(fit.floor - reference_error, 0.0);
    return fit;
}

/// Of the pictures at the end of the runs.
Json last_figures(const MeasuredRow& row, const std::string& layer) {
    std::vector<double> ratios, errors, flips;
    for (const Json& run : row.runs) {
        const Json& e = run["points"].back()["errors"][layer];
        if (e["mean_ratio"].is_number()) ratios.push_back(e["mean_ratio"].get<double>() - 1);
        errors.push_back(e["relmse"]);
        flips.push_back(e["flip"]);
    }
    const Mean signed_mean = mean(ratios);
    return {{"signed_mean", ratios.empty() ? Json() : Json(signed_mean.value)},
            {"signed_mean_error", signed_mean.error},
            {"last_relmse", mean(errors).value},
            {"last_flip", mean(flips).value}};
}

Json layer_result(const MeasuredRow& row, const std::string& layer, double reference_error) {
    const std::vector<ErrorRun> runs = error_runs(row, layer);
    const ErrorFit fit = fit_error(runs);
    const double bias = std::sqrt(without_reference(fit, reference_error).floor);
    const double bias_error = bias > 0 ? fit.floor_error / (2 * bias) : std::sqrt(fit.floor_error);
    Json result{{"bias", bias},       {"bias_error", bias_error},
                {"noise", fit.noise}, {"noise_error", fit.noise_error},
                {"floor", fit.floor}, {"residual", fit.residual}};
    result.update(last_figures(row, layer));
    return result;
}

/// Times of rendering that were measured, the first and the last.
struct Span {
    double first = std::numeric_limits<double>::infinity(), last = 0;
};
Span measured_span(const MeasuredRow& row) {
    Span span;
    for (const Json& run : row.runs)
        for (const Json& point : run["points"]) {
            span.first = std::min(span.first, point["seconds"].get<double>());
            span.last = std::max(span.last, point["seconds"].get<double>());
        }
    return span;
}

/// A row's whole picture: error over time, preparation included.
struct Curve {
    ErrorFit fit;
    Span span;
    double build = 0;
};

Json at_time(const Curve& curve, double seconds) {
    const double t = seconds - curve.build;
    const bool begun = t > 0;
    return {{"seconds", seconds},
            {"relmse", begun ? json_number(curve.fit.at(t)) : Json()},
            {"beyond", !(t >= curve.span.first && t <= curve.span.last)}};
}

Json at_error(const Curve& curve, double error) {
    const double t = curve.fit.seconds_to(error);
    return {{"relmse", error},
            {"seconds", json_number(curve.build + t)},
            {"beyond", !(t >= curve.span.first && t <= curve.span.last)}};
}

/// 1, 2 or 5 times a power of ten next to `value`, on a log scale.
double round_number(double value) {
    const double decade = std::pow(10, std::floor(std::log10(value)));
    double best = decade;
    for (double step : {1.0, 2.0, 5.0, 10.0})
        if (std::abs(std::log(step * decade / value)) < std::abs(std::log(best / value))) best = step * decade;
    return best;
}

/// kLevels round numbers, evenly from `from` to `to` on a log scale, without repeats.
std::vector<double> levels(double from, double to) {
    std::vector<double> values;
    if (!(from > 0) || !(to > 0) || !std::isfinite(from) || !std::isfinite(to)) return values;
    for (int i = 0; i < kLevels; ++i) {
        const double value = round_number(from * std::pow(to / from, double(i) / (kLevels - 1)));
        if (values.empty() || value != values.back()) values.push_back(value);
    }
    return values;
}

/// Times from the first picture of any row to the last; errors from twice the worst row's at its end to the best one's.
void add_equals(const std::vector<Curve>& curves, std::vector<Json>& results) {
    const double never = std::numeric_limits<double>::infinity();
    double from = never, to = 0, worst = 0, best = never;
    for (const Curve& c : curves) {
        from = std::min(from, c.build + c.span.first);
        to = std::max(to, c.build + c.span.last);
        worst = std::max(worst, c.fit.at(c.span.last));
        best = std::min(best, c.fit.at(c.span.last));
    }
    const std::vector<double> times = levels(from, to), errors = levels(2 * worst, best);
    for (size_t i = 0; i < curves.size(); ++i) {
        results[i]["equal_time"] = results[i]["equal_error"] = Json::array();
        for (double t : times) results[i]["equal_time"].push_back(at_time(curves[i], t));
        for (double e : errors) results[i]["equal_error"].push_back(at_error(curves[i], e));
    }
}

Json mean_errors(const MeasuredRow& row, int spp) {
    std::map<std::string, std::map<std::string, std::vector<double>>> values;
    for (const Json& run : row.runs)
        if (const Json* point = point_at(run, spp))
            for (const auto& [layer, errors] : (*point)["errors"].items())
                for (const auto& [name, value] : errors.items())
                    if (value.is_number()) values[layer][name].push_back(value);
    Json result = Json::object();
    for (const auto& [layer, errors] : values)
        for (const auto& [name, list] : errors) result[layer][name] = mean(list).value;
    return result;
}

}  // namespace

std::vector<Json> row_results(const std::vector<MeasuredRow>& rows, const Json& reference) {
    std::vector<Json> results;
    std::vector<Curve> curves;
    const int spp = common_spp(rows);
    const double paper_first = paper_rows().front().paper_seconds;
    for (const MeasuredRow& row : rows) {
        const double build = median_of(row.runs, [](const Json& run) { return run["seconds"]["build"].get<double>(); });
        const double render = median_of(row.runs, [&](const Json& run) {
            const Json* point = point_at(run, spp);
            return point ? (*point)["seconds"].get<double>() : 0.0;
        });
        const Json first = results.empty() ? Json() : results.front();
        const double total = build + render;
        const double paper = row.row.paper_seconds;
        Json result{{"line", "row"},
                    {"row", row.row.name},
                    {"settings", row.row.settings},
                    {"runs", row.runs.size()},
                    {"spp", spp},
                    {"build_seconds", build},
                    {"render_seconds", render},
                    {"total_seconds", total},
                    {"times_as_fast", first.is_null() ? 1.0 : first["total_seconds"].get<double>() / total},
                    {"paper_seconds", paper > 0 ? Json(paper) : Json()},
                    {"paper_times_as_fast", paper > 0 ? Json(paper_first / paper) : Json()},
                    {"peak_rss_bytes",
                     median_of(row.runs, [](const Json& run) { return run["peak_rss_bytes"].get<double>(); })},
                    {"errors", mean_errors(row, spp)}};
        for (const auto& [layer, reference_error] : reference["errors"].items())
            if (!row.runs.empty() && row.runs.front()["points"].back()["errors"].contains(layer))
                result["layers"][layer] = layer_result(row, layer, reference_error);
        curves.push_back({without_reference(fit_error(error_runs(row, kWhole)), reference["errors"][kWhole]),
                          measured_span(row), build});
        results.push_back(std::move(result));
    }
    add_equals(curves, results);
    return results;
}

}  // namespace tress
