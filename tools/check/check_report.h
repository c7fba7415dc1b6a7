// SPDX-License-Identifier: MIT
// Rows that were measured, as text, JSON and the table of docs/extremes.md.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/check/check_row.h"

namespace tress {

struct CheckedRow {
    CheckRow row;
    Outcome outcome;
    std::string thrown;  // what() of an exception that ended it; empty: none
    double seconds = 0;
};

struct CheckReport {
    std::string processor, compiler, isa;
    int threads = 0;
    std::vector<CheckedRow> rows;
};

enum class Verdict { passed, failed, does_not_apply };
Verdict verdict(const CheckedRow& row);
bool passes(const CheckReport& report);  // no row failed

/// A line for the row, and one for each of its figures.
std::string to_text(const CheckedRow& row);
/// "45 passed, 1 failed, 1 does not apply".
std::string summary(const CheckReport& report);
nlohmann::ordered_json to_json(const CheckReport& report);
std::string to_markdown(const CheckReport& report);

}  // namespace tress
