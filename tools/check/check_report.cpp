// SPDX-License-Identifier: MIT
#include "tools/check/check_report.h"

#include <algorithm>
#include <cmath>

#include "tools/number_text.h"

namespace tress {
namespace {

constexpr int kDigits = 3;

std::string number(double value, const std::string& unit) {
    return significant(value, kDigits) + (unit.empty() ? "" : " " + unit);
}

/// "at most 0.02 %", "1", "from 0.9 to 1.1".
std::string bound_of(const Figure& f) {
    const bool low = std::isfinite(f.lowest), high = std::isfinite(f.highest);
    if (low && high && f.lowest == f.highest) return number(f.lowest, f.unit);
    if (low && high)
        return significant(f.lowest, kDigits + 1) + " to " + significant(f.highest, kDigits + 1) +
               (f.unit.empty() ? "" : " " + f.unit);
    if (high) return "at most " + number(f.highest, f.unit);
    if (low) return "at least " + number(f.lowest, f.unit);
    return "none";
}

const char* word(Verdict v) { return v == Verdict::passed ? "pass" : v == Verdict::failed ? "FAIL" : "does not apply"; }

/// Why a row has no figures.
std::string reason(const CheckedRow& row) {
    return row.thrown.empty() ? row.outcome.does_not_apply : "threw: " + row.thrown;
}

int count(const CheckReport& report, Verdict v) {
    return int(std::count_if(report.rows.begin(), report.rows.end(),
                             [&](const CheckedRow& row) { return verdict(row) == v; }));
}

}  // namespace

Verdict verdict(const CheckedRow& row) {
    if (!row.thrown.empty()) return Verdict::failed;
    if (!row.outcome.does_not_apply.empty()) return Verdict::does_not_apply;
    return row.outcome.passes() ? Verdict::passed : Verdict::failed;
}

bool passes(const CheckReport& report) { return count(report, Verdict::failed) == 0; }

std::string to_text(const CheckedRow& row) {
    std::string text = std::string(row.row.id) + "  " + word(verdict(row)) + "  " + row.row.name + "\n";
    text += "      expected: " + std::string(row.row.expected) + "\n";
    if (!reason(row).empty()) text += "      " + reason(row) + "\n";
    for (const Figure& f : row.outcome.figures)
        text += "      " + f.what + ": " + number(f.measured, f.unit) + " (bound: " + bound_of(f) + ")" +
                (f.passes() ? "" : "  FAIL") + "\n";
    return text;
}

std::string summary(const CheckReport& report) {
    return std::to_string(count(report, Verdict::passed)) + " passed, " +
           std::to_string(count(report, Verdict::failed)) + " failed, " +
           std::to_string(count(report, Verdict::does_not_apply)) + " do not apply";
}

nlohmann::ordered_json to_json(const CheckReport& report) {
    using Json = nlohmann::ordered_json;
    const auto finite = [](double v) { return std::isfinite(v) ? Json(v) : Json(); };
    Json rows = Json::array();
    for (const CheckedRow& row : report.rows) {
        Json figures = Json::array();
        for (const Figure& f : row.outcome.figures)
            figures.push_back({{"what", f.what},
                               {"measured", finite(f.measured)},
                               {"lowest", finite(f.lowest)},
                               {"highest", finite(f.highest)},
                               {"unit", f.unit},
                               {"pass", f.passes()}});
        rows.push_back({{"id", row.row.id},
                        {"case", row.row.name},
                        {"expected", row.row.expected},
                        {"verdict", word(verdict(row))},
                        {"pass", verdict(row) == Verdict::passed},
                        {"reason", reason(row)},
                        {"seconds", row.seconds},
                        {"figures", figures}});
    }
    return {{"processor", report.processor},
            {"compiler", report.compiler},
            {"isa", report.isa},
            {"threads", report.threads},
            {"version", TRESS_VERSION},
            {"pass", passes(report)},
            {"rows", rows}};
}

std::string to_markdown(const CheckReport& report) {
    std::string text =
        "# Stiff and extreme cases\n\nMade by `tress check --markdown`, tress " TRESS_VERSION ", on " +
        report.processor + ", " + std::to_string(report.threads) + " threads, " + report.isa + ", " + report.compiler +
        ": " + summary(report) +
        ".\n\n| row | case, and what it must give | measured | bound | |\n| --- | --- | --- | --- | --- |\n";
    for (const CheckedRow& row : report.rows) {
        std::string measured = reason(row), bound;
        for (const Figure& f : row.outcome.figures) {
            const char* gap = measured.empty() ? "" : "<br>";
            measured += gap + f.what + ": " + number(f.measured, f.unit);
            bound += gap + bound_of(f);
        }
        text += "| " + std::string(row.row.id) + " | **" + row.row.name + "** " + row.row.expected + " | " + measured +
                " | " + bound + " | " + word(verdict(row)) + " |\n";
    }
    return text;
}

}  // namespace tress
