// SPDX-License-Identifier: MIT
#include "tools/study/csv.h"

#include <algorithm>

namespace tress {
namespace {

std::string field(const Json& value) {
    if (value.is_null()) return {};
    std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    for (size_t at = text.find('"'); at != std::string::npos; at = text.find('"', at + 2)) text.insert(at, 1, '"');
    return "\"" + text + "\"";
}

std::string joined(const std::vector<std::string>& fields) {
    std::string line;
    for (size_t i = 0; i < fields.size(); ++i) line += (i ? "," : "") + fields[i];
    return line + "\r\n";
}

}  // namespace

std::string rows_csv(const std::vector<Json>& lines) {
    std::vector<std::string> columns;
    for (const Json& line : lines) {
        const Json flat = line.flatten();
        for (const auto& [pointer, value] : flat.items())
            if (std::find(columns.begin(), columns.end(), pointer) == columns.end()) columns.push_back(pointer);
    }
    std::vector<std::string> names;
    for (const std::string& column : columns) names.push_back(field(column.substr(1)));
    std::string text = joined(names);
    for (const Json& line : lines) {
        const Json flat = line.flatten();
        std::vector<std::string> fields;
        for (const std::string& column : columns)
            fields.push_back(field(flat.contains(column) ? flat[column] : Json()));
        text += joined(fields);
    }
    return text;
}

std::string points_csv(const std::vector<MeasuredRow>& rows) {
    constexpr const char* kErrors[] = {"relmse", "relmse_trimmed", "mean_ratio", "flip"};
    std::string text = "row,seed,spp,build_seconds,render_seconds,layer,relmse,relmse_trimmed,mean_ratio,flip\r\n";
    for (const MeasuredRow& row : rows)
        for (const Json& run : row.runs)
            for (const Json& point : run["points"])
                for (const auto& [layer, errors] : point["errors"].items()) {
                    std::vector<std::string> fields{field(row.row.name),     field(run["seed"]),
                                                    field(point["spp"]),     field(run["seconds"]["build"]),
                                                    field(point["seconds"]), layer};
                    for (const char* error : kErrors) fields.push_back(field(errors[error]));
                    text += joined(fields);
                }
    return text;
}

}  // namespace tress
