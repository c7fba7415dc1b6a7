// SPDX-License-Identifier: MIT
#include "tools/study/methods/verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/error_fit.h"
#include "tools/number_text.h"
#include "tools/study/methods/picture_error.h"
#include "tools/study/methods/study_row.h"

namespace tress {
namespace {

constexpr double kEnough = 0.1;       // of the smallest error shown: what a reference may err
constexpr double kNotWorthIt = 1.25;  // times as long as the best, at every error: not worth it

double number_or_infinity(const Json& value) {
    return value.is_number() ? value.get<double>() : std::numeric_limits<double>::infinity();
}

std::string name_of(const Json& row) { return row["row"]; }

/// Seconds of each row to the error of `level`, and the quickest.
struct Race {
    double error = 0;
    std::vector<double> seconds;
    size_t best = 0;

    bool won() const { return std::isfinite(seconds[best]); }
    double times_best(size_t row) const { return seconds[row] / seconds[best]; }
};

std::vector<Race> races(const std::vector<Json>& rows) {
    std::vector<Race> all;
    for (size_t level = 0; level < rows.front()["equal_error"].size(); ++level) {
        Race race{rows.front()["equal_error"][level]["relmse"], {}, 0};
        for (const Json& row : rows) race.seconds.push_back(number_or_infinity(row["equal_error"][level]["seconds"]));
        race.best = size_t(std::min_element(race.seconds.begin(), race.seconds.end()) - race.seconds.begin());
        all.push_back(std::move(race));
    }
    return all;
}

/// "3.1 s" or "3.1 s to 20 s".
std::string range(const std::string& first, const std::string& last) {
    return first == last ? first : first + " to " + last;
}

/// Races next to each other with the same winner, in words: "From a relMSE of 0.1 down to 0.01, RT / P / – is the
/// quickest: 3.1 s to 20 s, 1.8 to 2.2 times as fast as RT / RT / RT."
std::string winner(const std::vector<Json>& rows, std::span<const Race> same) {
    const Race &first = same.front(), &last = same.back();
    const std::string coarse = significant(first.error, 1), fine = significant(last.error, 1);
    if (!first.won()) return "No row gets to a relMSE of " + coarse + ". ";
    std::string text =
        same.size() == 1 ? "To a relMSE of " + coarse : "From a relMSE of " + coarse + " down to " + fine;
    text += ", " + name_of(rows[first.best]) +
            " is the quickest: " + range(duration(first.seconds[first.best]), duration(last.seconds[last.best]));
    if (first.best == 0) return text + ". ";
    if (!std::isfinite(last.seconds[0])) return text + "; " + name_of(rows[0]) + " never gets to " + fine + ". ";
    return text + ", " + range(significant(first.times_best(0), 2), significant(last.times_best(0), 2)) +
           " times as fast as " + name_of(rows[0]) + ". ";
}

std::string winners(const std::vector<Json>& rows, std::span<const Race> races) {
    std::string text;
    while (!races.empty()) {
        size_t same = 1;
        while (same < races.size() && races[0].won() && races[same].won() && races[same].best == races[0].best) ++same;
        text += winner(rows, races.first(same));
        races = races.subspan(same);
    }
    return text;
}

std::string list(const std::vector<std::string>& names) {
    std::string text;
    for (size_t i = 0; i < names.size(); ++i) text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return text;
}

std::string losers(const std::vector<Json>& rows, const std::vector<Race>& races) {
    std::vector<std::string> names;
    for (size_t row = 0; row < rows.size(); ++row) {
        const bool slow = std::all_of(races.begin(), races.end(), [&](const Race& race) {
            return !race.won() || race.times_best(row) > kNotWorthIt;
        });
        if (slow) names.push_back(name_of(rows[row]));
    }
    if (names.empty() || names.size() == rows.size()) return {};
    return "Not worth it at any of these errors, by " + significant(kNotWorthIt, 3) +
           " times and more: " + list(names) + ". ";
}

/// Rows whose bias keeps them from the smallest error.
std::string biased(const std::vector<Json>& rows, const std::vector<Race>& races) {
    if (races.empty()) return {};
    std::vector<std::string> names;
    for (size_t row = 0; row < rows.size(); ++row)
        if (!std::isfinite(races.back().seconds[row])) {
            const Json& whole = rows[row]["layers"][kWhole];
            const double mean = whole["signed_mean"].is_number() ? whole["signed_mean"].get<double>() : 0;
            names.push_back(name_of(rows[row]) + " (" + significant(100 * whole["bias"].get<double>(), 2) +
                            " %, its mean " + (mean > 0 ? "+" : "") + significant(100 * mean, 2) + " %)");
        }
    if (names.empty() || names.size() == rows.size()) return {};
    return "Kept from " + significant(races.back().error, 1) + " by their bias, however long they run: " + list(names) +
           ". ";
}

const Json* find_row(const std::vector<Json>& rows, const std::string& name) {
    for (const Json& row : rows)
        if (row["row"] == name) return &row;
    return nullptr;
}

double seconds_to(const Json& row, const char* layer, double error, const Json& reference) {
    const Json& l = row["layers"][layer];
    const double floor = std::max(l["floor"].get<double>() - reference["errors"][layer].get<double>(), 0.0);
    return row["build_seconds"].get<double>() + ErrorFit{.floor = floor, .noise = l["noise"]}.seconds_to(error);
}

/// The paper's own comparison: projection for rays in Type 2.
std::string projection_claim(const std::vector<Json>& rows, const Json& reference) {
    const Json* const ray = find_row(rows, "RT / RT / –");
    const Json* const projection = find_row(rows, "RT / P / –");
    constexpr const char* kLayer = "type2";
    if (!ray || !projection || !(*ray)["layers"].contains(kLayer) || !(*projection)["layers"].contains(kLayer))
        return {};
    if (!(*ray)["paper_seconds"].is_number() || !(*projection)["paper_seconds"].is_number()) return {};
    const auto ratio = [&](const char* of) { return (*ray)[of].get<double>() / (*projection)[of].get<double>(); };
    std::string text = "Projection in place of rays is " + significant(ratio("paper_seconds"), 3) +
                       " times as fast in the paper; here it is " + significant(ratio("total_seconds"), 2) +
                       " times at equal samples";
    const double error = std::max((*ray)["layers"][kLayer]["last_relmse"].get<double>(),
                                  (*projection)["layers"][kLayer]["last_relmse"].get<double>());
    const double by_rays = seconds_to(*ray, kLayer, error, reference);
    const double by_projection = seconds_to(*projection, kLayer, error, reference);
    if (std::isfinite(by_rays) && std::isfinite(by_projection))
        text += " and " + significant(by_rays / by_projection, 2) + " times at equal error of Type 2 (relMSE " +
                significant(error, 2) + ")";
    return text + ". ";
}

Json reference_shares(const std::vector<Json>& rows, const Json& reference) {
    Json shares = Json::object();
    for (const auto& [layer, error] : reference["errors"].items()) {
        double smallest = std::numeric_limits<double>::infinity();
        for (const Json& row : rows)
            if (row.contains("layers") && row["layers"].contains(layer))
                smallest = std::min(smallest, row["layers"][layer]["last_relmse"].get<double>());
        if (!std::isfinite(smallest)) continue;
        shares[layer] = {{"error", error},
                         {"smallest_shown", smallest},
                         {"share", smallest > 0 ? error.get<double>() / smallest : 1.0}};
    }
    return shares;
}

}  // namespace

Json verdict_of(const std::vector<Json>& rows, const Json& reference) {
    const std::vector<Race> all = rows.empty() ? std::vector<Race>{} : races(rows);
    const Json shares = reference_shares(rows, reference);
    const bool enough = std::all_of(shares.begin(), shares.end(),
                                    [](const Json& layer) { return layer["share"].get<double>() <= kEnough; });
    std::string text = winners(rows, all) + losers(rows, all) + biased(rows, all) + projection_claim(rows, reference);
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return {{"line", "verdict"}, {"text", text}, {"reference", shares}, {"reference_is_enough", enough}};
}

}  // namespace tress
