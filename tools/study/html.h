// SPDX-License-Identifier: MIT
// Pieces of a page: text made safe, and tables whose numbers come straight from the lines of the study.
#pragma once

#include <string>
#include <vector>

#include "tools/study/study_log.h"

namespace tress {

std::string escape_html(const std::string& text);

/// How a number is shown: times `scale`, with so many digits, and `unit` behind it.
struct NumberFormat {
    double scale = 1;
    int digits = 3;
    const char* unit = "";
    bool sign = false;  // "+1.2"
};

/// A number of a line, named by where it stands: "row.3/layers/whole/bias" is the fourth line "row" of the file, and a
/// JSON pointer in it. A page's reader, or a test, finds it again by that. Null: `missing` is shown.
struct NumberCell {
    std::string line;  // "row.3"
    const Json* json = nullptr;
    std::string pointer;  // "/layers/whole/bias"
    NumberFormat format;
    const char* missing = "–";
    std::string error_pointer = {};  // of its standard error, shown behind ±; empty: none
    bool beyond = false, best = false;
};
std::string to_html(const NumberCell& cell);

struct Column {
    std::string name, title;  // a longer word on it
};
struct ColumnGroup {
    std::string name;
    int columns = 1;
};
struct TableRow {
    std::string name;
    std::vector<NumberCell> cells;
};
struct Table {
    std::string id, heading, caption;  // the caption is HTML
    std::vector<ColumnGroup> groups;   // above the columns; empty: none
    std::string first_column = "row";
    std::vector<Column> columns;
    std::vector<TableRow> rows;
};
std::string to_html(const Table& table);

/// Marks the smallest (or largest) number of a column.
void mark_best(Table& table, size_t column, bool smallest);

}  // namespace tress
