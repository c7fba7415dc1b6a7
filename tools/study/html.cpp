// SPDX-License-Identifier: MIT
#include "tools/study/html.h"

#include "tools/number_text.h"

namespace tress {
namespace {

std::string number_text(double value, const NumberFormat& format) {
    const double shown = value * format.scale;
    std::string text;
    if (format.sign && shown > 0) text.push_back('+');
    return text.append(significant(shown, format.digits)).append(format.unit);
}

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + escape_html(value) + "\"";
}

const Json* find(const Json& line, const std::string& pointer) {
    const Json::json_pointer place(pointer);
    return line.contains(place) ? &line.at(place) : nullptr;
}

}  // namespace

std::string escape_html(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        switch (c) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            default:
                safe += c;
        }
    }
    return safe;
}

std::string to_html(const NumberCell& cell) {
    const Json* const value = find(*cell.json, cell.pointer);
    if (!value || !value->is_number()) return "<td class=\"missing\">" + escape_html(cell.missing) + "</td>";
    std::string classes = cell.beyond ? "beyond" : "";
    if (cell.best) classes += classes.empty() ? "best" : " best";
    std::string html = "<td";
    if (!classes.empty()) html += attribute("class", classes);
    html += attribute("data-of", cell.line + cell.pointer) + attribute("data-value", value->dump());
    if (cell.format.scale != 1) html += attribute("data-scale", Json(cell.format.scale).dump());
    html += ">" + escape_html(number_text(value->get<double>(), cell.format));
    const Json* const error = cell.error_pointer.empty() ? nullptr : find(*cell.json, cell.error_pointer);
    if (error && error->is_number() && error->get<double>() > 0)
        html += " <small>± " + escape_html(significant(error->get<double>() * cell.format.scale, 2)) + "</small>";
    return html + "</td>";
}

std::string to_html(const Table& table) {
    std::string html = "<section class=\"table\"" + attribute("id", table.id) + "><h2>" + escape_html(table.heading) +
                       "</h2><p>" + table.caption + "</p><div class=\"scroll\"><table>\n<thead>";
    if (!table.groups.empty()) {
        html += "<tr><td></td>";
        for (const ColumnGroup& group : table.groups)
            html += "<th scope=\"colgroup\" colspan=\"" + std::to_string(group.columns) + "\">" +
                    escape_html(group.name) + "</th>";
        html += "</tr>";
    }
    html += "<tr><th scope=\"col\">" + escape_html(table.first_column) + "</th>";
    for (const Column& column : table.columns)
        html += "<th scope=\"col\"" + (column.title.empty() ? "" : attribute("title", column.title)) + ">" +
                escape_html(column.name) + "</th>";
    html += "</tr></thead>\n<tbody>\n";
    for (const TableRow& row : table.rows) {
        html += "<tr><th scope=\"row\">" + escape_html(row.name) + "</th>";
        for (const NumberCell& cell : row.cells) html += to_html(cell);
        html += "</tr>\n";
    }
    return html + "</tbody></table></div></section>\n";
}

void mark_best(Table& table, size_t column, bool smallest) {
    NumberCell* best = nullptr;
    double best_value = 0;
    for (TableRow& row : table.rows) {
        NumberCell& cell = row.cells[column];
        const Json* const number = find(*cell.json, cell.pointer);
        if (!number || !number->is_number()) continue;
        const double value = number->get<double>();
        if (best && (smallest ? value >= best_value : value <= best_value)) continue;
        best = &cell;
        best_value = value;
    }
    if (best) best->best = true;
}

}  // namespace tress
