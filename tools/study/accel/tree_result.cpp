// SPDX-License-Identifier: MIT
#include "tools/study/accel/tree_result.h"

#include <algorithm>
#include <cmath>

#include "tools/study/median.h"
#include "tools/study/sweep.h"

namespace tress {
namespace {

Json accel_texts(const TreeRow& row, const Options& base) {
    Options options = with_settings(base, row.settings);
    Json texts = Json::object();
    for (const OptionField& field : option_fields(options))
        if (field.key.starts_with("accel.")) texts[field.key] = option_text(field);
    return texts;
}

template <class Of>
std::vector<double> of_runs(const MeasuredTree& tree, const Of& of) {
    std::vector<double> values;
    for (const Json& run : tree.runs) values.push_back(of(run));
    return values;
}

/// Of one set of rays. Work is the same in every round.
Json rays_of(const MeasuredTree& tree, const std::string& set, const Json& work, double step_cost, int threads) {
    const std::vector<double> rates =
        of_runs(tree, [&](const Json& run) { return run["rates"][set]["mrays_per_second"].get<double>(); });
    const double rate = median(rates), steps = work["steps"], tests = work["tests"];
    return {{"mrays_per_second", rate},
            {"lowest", *std::min_element(rates.begin(), rates.end())},
            {"highest", *std::max_element(rates.begin(), rates.end())},
            {"microseconds", threads / rate},
            {"steps", steps},
            {"leaves", work["leaves"]},
            {"tests", tests},
            {"cost", step_cost * steps + tests}};
}

Json row_line(const MeasuredTree& tree, const TreeBasis& basis, int threads) {
    Json line{{"line", "row"}, {"row", tree.row.name}, {"settings", tree.row.settings}};
    line["accel"] = accel_texts(tree.row, basis.options);
    const Json& run = tree.runs.front();
    if (run.contains("refused")) {
        line["refused"] = run["refused"];
        return line;
    }
    const double step_cost = basis.options.accel.traversal_cost;
    line["rounds"] = tree.runs.size();
    line["build_seconds"] = median(of_runs(tree, [](const Json& r) { return r["build_seconds"].get<double>(); }));
    Json& s = line["statistics"] = run["statistics"];
    s["bytes_per_segment"] = s["bytes"].get<double>() / double(std::max<uint64_t>(basis.segments, 1));
    line["sah_cost"] = step_cost * s["sah_steps"].get<double>() + s["sah_tests"].get<double>();
    line["rays"] = Json::object();
    for (const auto& [set, rate] : run["rates"].items())
        line["rays"][set] = rays_of(tree, set, rate, step_cost, threads);
    return line;
}

void add_times_as_fast(Json& row, const Json& first) {
    if (row.contains("refused") || first.contains("refused") || row["rays"].empty()) return;
    double logarithms = 0;
    for (auto& [set, rays] : row["rays"].items()) {
        const double times =
            rays["mrays_per_second"].get<double>() / first["rays"][set]["mrays_per_second"].get<double>();
        rays["times_as_fast"] = times;
        logarithms += std::log(times);
    }
    row["times_as_fast"] = std::exp(logarithms / double(row["rays"].size()));
}

}  // namespace

std::vector<Json> tree_results(const std::vector<MeasuredTree>& trees, const TreeBasis& basis, int threads) {
    std::vector<Json> rows;
    for (const MeasuredTree& tree : trees) {
        rows.push_back(row_line(tree, basis, threads));
        add_times_as_fast(rows.back(), rows.front());
    }
    return rows;
}

std::vector<std::string> ray_sets(const std::vector<Json>& rows) {
    std::vector<std::string> sets;
    for (const Json& row : rows)
        if (row.contains("rays"))
            for (const auto& [set, unused] : row["rays"].items())
                if (std::find(sets.begin(), sets.end(), set) == sets.end()) sets.push_back(set);
    return sets;
}

}  // namespace tress
