// SPDX-License-Identifier: MIT
#include "tools/study/accel/tree_spread.h"

#include <algorithm>
#include <cmath>

#include "core/rank_correlation.h"
#include "tools/number_text.h"
#include "tools/study/accel/tree_result.h"

namespace tress {
namespace {

constexpr size_t kFewestCorrelated = 3;
constexpr double kHundred = 100;  // two orders of magnitude

using Rows = std::vector<const Json*>;

double rate(const Json& row, const std::string& set) { return row["rays"][set]["mrays_per_second"]; }

bool same_depth(const Json& a, const Json& b) {
    for (const char* key : {"accel.depth_base", "accel.depth_factor"})
        if (a["accel"][key] != b["accel"][key]) return false;
    return true;
}

template <class Of>
std::pair<const Json*, const Json*> least_and_most(const Rows& rows, const Of& of) {
    const auto [least, most] =
        std::minmax_element(rows.begin(), rows.end(), [&](const Json* a, const Json* b) { return of(*a) < of(*b); });
    return {*least, *most};
}

double ratio(const Rows& rows, const std::string& set) {
    const auto [least, most] = least_and_most(rows, [&](const Json& row) { return rate(row, set); });
    return rate(*most, set) / rate(*least, set);
}

Json spread_of(const Rows& rows, const Rows& at_depth, const std::string& set) {
    const auto [least, most] = least_and_most(rows, [&](const Json& row) { return rate(row, set); });
    std::vector<double> predicted, counted, measured;
    for (const Json* row : rows) {
        predicted.push_back((*row)["sah_cost"]);
        counted.push_back((*row)["rays"][set]["cost"]);
        measured.push_back((*row)["rays"][set]["microseconds"]);
    }
    const auto correlation = [&](const std::vector<double>& cost) {
        const double r = rank_correlation(cost, measured);
        return rows.size() < kFewestCorrelated || !std::isfinite(r) ? Json() : Json(r);
    };
    const double in_all = ratio(rows, set);
    return {{"best", (*most)["row"]},
            {"worst", (*least)["row"]},
            {"most", rate(*most, set)},
            {"least", rate(*least, set)},
            {"ratio", in_all},
            {"orders", std::log10(in_all)},
            {"ratio_at_depth", ratio(at_depth, set)},
            {"predicted_correlation", correlation(predicted)},
            {"counted_correlation", correlation(counted)}};
}

/// "1.2 (primary), 3 (shadow) and 4 (gather)".
std::string of_sets(const Json& sets, const char* key, int digits) {
    std::string text;
    size_t at = 0;
    for (const auto& [set, figures] : sets.items()) {
        text += at == 0 ? "" : at + 1 == sets.size() ? " and " : ", ";
        text += (figures[key].is_number() ? significant(figures[key], digits) : "none") + " (" + set + ")";
        ++at;
    }
    return text;
}

std::string percent_more(double ratio) {
    const double percent = 100 * (ratio - 1);
    return significant(std::abs(percent), 2) + " % " + (percent < 0 ? "less" : "more");
}

std::string best_in_words(const Json& best, const Json& first) {
    if (!best.contains("times_as_fast")) return {};  // the scene's own tree is too large
    if (&best == &first) return "No tree is faster over all than " + first["row"].get<std::string>() + ". ";
    const auto of = [](const Json& row, const char* key) { return row["statistics"][key].get<double>(); };
    return "Fastest over all is " + best["row"].get<std::string>() + ": " + significant(best["times_as_fast"], 3) +
           " times as fast as " + first["row"].get<std::string>() + ", with " +
           percent_more(of(best, "bytes") / of(first, "bytes")) + " memory and " +
           percent_more(best["build_seconds"].get<double>() / first["build_seconds"].get<double>()) +
           " time to build. ";
}

std::string text_of(const Json& spread, const Rows& rows, const Rows& at_depth, const Json& best) {
    const Json& sets = spread["rays"];
    std::string text =
        "Of " + std::to_string(rows.size()) +
        " trees the best answers so many times as many rays a second as the worst: " + of_sets(sets, "ratio", 3) + ". ";
    const auto above = std::count_if(sets.begin(), sets.end(), [](const Json& s) { return s["ratio"] > kHundred; });
    text += "The paper speaks of more than two orders of magnitude; ";
    text += size_t(above) == sets.size() ? "so do these" : above ? "here some do" : "these stay below";
    text += ". ";
    if (at_depth.size() < rows.size() && at_depth.size() > 1)
        text += "Among the " + std::to_string(at_depth.size()) +
                " trees whose limit of depth is the scene's own it is " + of_sets(sets, "ratio_at_depth", 3) + ". ";
    text += best_in_words(best, *rows.front());
    if (rows.size() >= kFewestCorrelated)
        text +=
            "The cost that the surface area heuristic predicts orders the trees as their time a ray does with a rank "
            "correlation of " +
            of_sets(sets, "predicted_correlation", 2) + "; steps and tests as counted, with " +
            of_sets(sets, "counted_correlation", 2) + ". ";
    if (const size_t refused = spread["refused"])
        text += std::to_string(refused) + (refused == 1 ? " tree was" : " trees were") + " refused as too large. ";
    text.pop_back();
    return text;
}

}  // namespace

Json tree_spread(const std::vector<Json>& all) {
    Rows rows, at_depth;
    for (const Json& row : all) {
        if (row.contains("refused") || row["rays"].empty()) continue;
        rows.push_back(&row);
        if (same_depth(row, all.front())) at_depth.push_back(&row);
    }
    Json spread{{"line", "spread"}, {"trees", rows.size()}, {"refused", all.size() - rows.size()}};
    if (rows.empty()) {
        spread["rays"] = Json::object();
        spread["text"] = "No tree was measured: no ray of this scene meets hair, or every tree is too large.";
        return spread;
    }
    if (at_depth.empty()) at_depth = rows;
    const auto [worst, best] = least_and_most(
        rows, [](const Json& row) { return row.contains("times_as_fast") ? row["times_as_fast"].get<double>() : 0; });
    spread["best"] = (*best)["row"];
    spread["worst"] = (*worst)["row"];
    for (const std::string& set : ray_sets(all)) spread["rays"][set] = spread_of(rows, at_depth, set);
    spread["text"] = text_of(spread, rows, at_depth, *best);
    return spread;
}

}  // namespace tress
