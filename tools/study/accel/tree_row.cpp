// SPDX-License-Identifier: MIT
#include "tools/study/accel/tree_row.h"

#include <algorithm>
#include <span>

#include "core/error.h"
#include "tools/study/sweep.h"

namespace tress {
namespace {

constexpr std::string_view kGroup = "accel.";

/// One option, or what must be set together with it, at several values.
struct DefaultSweep {
    const char* fixed;  // "" or "key=value key=value"
    const char* sweep;
};
constexpr DefaultSweep kAll[] = {
    {"", "accel.traversal_cost=1,2,5,10,40,80,160"},
    {"", "accel.empty_bonus=0,0.5,0.8,0.95"},
    {"", "accel.bins=4,8,128"},
    {"", "accel.split=exact,spatial_median,object_median"},
    {"", "accel.clip=false"},
    {"", "accel.failed_splits=2,4"},
    {"", "accel.references=2,3,4,8,16"},
    {"accel.automatic=false", "accel.leaf_size=1,4,16,64"},
    {"accel.split=spatial_median accel.automatic=false", "accel.leaf_size=4,16"},
    {"accel.split=object_median accel.automatic=false", "accel.leaf_size=4,16"},
    {"accel.depth_factor=0", "accel.depth_base=4,8,12,16,20,24"},
};
constexpr DefaultSweep kFew[] = {
    {"", "accel.traversal_cost=5,80"},
    {"", "accel.empty_bonus=0,0.8"},
    {"", "accel.bins=4"},
    {"", "accel.split=object_median"},
    {"", "accel.clip=false"},
    {"accel.depth_factor=0", "accel.depth_base=4,8,12,16"},
};

std::vector<std::string> words(const std::string& row) {
    std::vector<std::string> all = split(row, ' ');
    std::erase(all, "");
    return all;
}

/// `where`: the flag that it comes from.
void check(const std::string& setting, const char* where) {
    if (!setting.starts_with(kGroup) || setting.find('=') == std::string::npos)
        throw InputError(where, "'" + setting + "', expected accel.key=value");
}

TreeRow row_of(std::vector<std::string> settings) {
    TreeRow row;
    for (const std::string& setting : settings)
        row.name += (row.name.empty() ? "" : ", ") + setting.substr(kGroup.size());
    if (settings.empty()) row.name = "the scene's own";
    row.settings = std::move(settings);
    with_settings({}, row.settings);  // throws where a key or a value is none
    return row;
}

void add(std::vector<TreeRow>& rows, const std::vector<std::string>& fixed, const std::vector<std::string>& sweeps) {
    for (const std::string& setting : fixed) check(setting, "--row");
    for (const std::string& sweep : sweeps) check(sweep, "--sweep");
    for (const std::vector<std::string>& point : grid(sweeps)) {
        std::vector<std::string> settings = fixed;
        settings.insert(settings.end(), point.begin(), point.end());
        TreeRow row = row_of(std::move(settings));
        if (std::none_of(rows.begin(), rows.end(), [&](const TreeRow& other) { return other.name == row.name; }))
            rows.push_back(std::move(row));
    }
}

}  // namespace

std::vector<TreeRow> tree_rows(const std::vector<std::string>& rows, const std::vector<std::string>& sweeps, bool few) {
    std::vector<TreeRow> all{row_of({})};
    for (const std::string& row : rows) {
        if (words(row).empty()) throw InputError("--row", "an empty row, expected accel.key=value");
        add(all, words(row), sweeps);
    }
    if (rows.empty() && !sweeps.empty()) add(all, {}, sweeps);
    if (rows.empty() && sweeps.empty())
        for (const DefaultSweep& d : few ? std::span<const DefaultSweep>(kFew) : kAll)
            add(all, words(d.fixed), {d.sweep});
    return all;
}

}  // namespace tress
