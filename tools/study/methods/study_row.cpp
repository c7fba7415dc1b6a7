// SPDX-License-Identifier: MIT
#include "tools/study/methods/study_row.h"

#include <algorithm>
#include <array>
#include <sstream>

#include "core/error.h"
#include "tools/study/sweep.h"

namespace tress {
namespace {

constexpr const char* kOff = "–";

struct MethodName {
    const char *name, *value;  // in tables; of the option
};
constexpr MethodName kLampMethods[] = {{kOff, "off"},      {"RT", "ray"},  {"DSM", "deep"}, {"OSM", "opacity"},
                                       {"CD", "clusters"}, {"PT", "path"}, {"auto", "auto"}};
constexpr MethodName kGatherMethods[] = {
    {kOff, "off"}, {"RT", "ray"}, {"P", "projection"}, {"PT", "path"}, {"auto", "auto"}};
constexpr MethodName kCrossingMethods[] = {
    {kOff, "off"}, {"RT", "ray"}, {"RT+DSM", "ray+deep"}, {"RT+OSM", "ray+opacity"}, {"RT+CD", "ray+clusters"},
    {"PT", "path"}};
constexpr MethodName kScatteredMethods[] = {{kOff, "off"}, {"PM", "photons"}, {"PT", "path"}};

struct TypeMethods {
    const char* key;
    std::span<const MethodName> methods;
};
const std::array<TypeMethods, kPathTypes> kTypes{{{"type1", kLampMethods},
                                                  {"type2", kGatherMethods},
                                                  {"type3", kCrossingMethods},
                                                  {"type4", kScatteredMethods},
                                                  {"type5", kScatteredMethods}}};

std::string text_of(Options& options, const std::string& key) {
    for (const OptionField& field : option_fields(options))
        if (field.key == key) return option_text(field);
    throw std::logic_error("no option " + key);
}

StudyRow row_of(const std::vector<std::string>& settings, double paper_seconds = 0) {
    return {method_name(options_of({{}, settings, 0}, {})), settings, paper_seconds};
}

/// "RT/P/-" as settings.
std::vector<std::string> settings_of_methods(const std::string& word, const std::string& row) {
    const std::vector<std::string> names = split(word, '/');
    if (names.size() > kTypes.size())
        throw InputError("--row", "'" + row + "', expected methods of at most five types, such as RT/P/-");
    std::vector<std::string> settings;
    for (size_t i = 0; i < names.size(); ++i) {
        const std::span<const MethodName> known = kTypes[i].methods;
        const std::string name = names[i] == "-" ? kOff : names[i];
        const auto found =
            std::find_if(known.begin(), known.end(), [&](const MethodName& m) { return name == m.name; });
        if (found == known.end()) {
            std::string list;
            for (const MethodName& m : known) list += (list.empty() ? "" : ", ") + std::string(m.name);
            throw InputError("--row", "'" + name + "' for " + kTypes[i].key + ", expected one of: " + list);
        }
        settings.push_back(std::string(kTypes[i].key) + "=" + found->value);
    }
    return settings;
}

bool chooses_method(const std::string& setting) {
    return std::any_of(kTypes.begin(), kTypes.end(),
                       [&](const TypeMethods& t) { return setting.starts_with(std::string(t.key) + "="); });
}

void append_to_name(std::string& name, const std::string& setting) { name += (name.empty() ? "" : ", ") + setting; }

}  // namespace

std::string method_name(const Options& options) {
    Options copy = options;
    std::string name;
    for (const TypeMethods& type : kTypes) {
        const bool scattered = type.methods.data() == kScatteredMethods;
        const std::string value = text_of(copy, type.key);
        if (scattered && copy.type4 == ScatteredMethod::off && copy.type5 == ScatteredMethod::off) break;
        for (const MethodName& m : type.methods)
            if (value == m.value) name += (name.empty() ? "" : " / ") + std::string(m.name);
    }
    return name;
}

std::vector<StudyRow> paper_rows() {
    struct PaperRow {
        const char* methods;
        double hours, minutes, seconds;
    };
    constexpr PaperRow kTable[] = {{"RT/RT/RT", 8, 13, 51}, {"DSM/RT/RT+DSM", 0, 35, 45}, {"RT/RT/-", 0, 26, 26},
                                   {"DSM/RT/-", 0, 25, 45}, {"RT/P/-", 0, 11, 13},        {"DSM/P/-", 0, 12, 45}};
    std::vector<StudyRow> rows;
    for (const PaperRow& r : kTable)
        rows.push_back(row_of(settings_of_methods(r.methods, r.methods), 3600 * r.hours + 60 * r.minutes + r.seconds));
    return rows;
}

std::vector<StudyRow> all_rows() {
    const auto usual = [](const MethodName& m) {
        return std::string(m.value) != "path" && std::string(m.value) != "auto";
    };
    std::vector<StudyRow> rows;
    for (const MethodName& lamp : kLampMethods)
        for (const MethodName& gather : kGatherMethods)
            for (const MethodName& crossing : kCrossingMethods) {
                const bool all_off = lamp.name == kOff && gather.name == kOff && crossing.name == kOff;
                if (all_off || !usual(lamp) || !usual(gather) || !usual(crossing)) continue;
                rows.push_back(row_of({std::string("type1=") + lamp.value, std::string("type2=") + gather.value,
                                       std::string("type3=") + crossing.value}));
            }
    return rows;
}

StudyRow parse_row(const std::string& text) {
    std::vector<std::string> settings;
    bool methods = false;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const bool assigns = word.find('=') != std::string::npos;
        methods |= !assigns || chooses_method(word);
        const std::vector<std::string> more = assigns ? std::vector{word} : settings_of_methods(word, text);
        settings.insert(settings.end(), more.begin(), more.end());
    }
    if (settings.empty()) throw InputError("--row", "an empty row, expected words such as RT/P/- or key=value");
    StudyRow row{{}, settings, 0};
    const Options options = options_of(row, {});  // throws where a key or value is none
    if (methods) row.name = method_name(options);
    for (const std::string& setting : settings)
        if (!chooses_method(setting)) append_to_name(row.name, setting);
    for (const StudyRow& paper : paper_rows())
        if (paper.name == row.name) row.paper_seconds = paper.paper_seconds;
    return row;
}

std::vector<StudyRow> across(const std::vector<StudyRow>& rows, const std::vector<std::vector<std::string>>& points) {
    std::vector<StudyRow> all;
    for (const StudyRow& row : rows)
        for (const std::vector<std::string>& point : points) {
            all.push_back(row);
            for (const std::string& setting : point) {
                all.back().settings.push_back(setting);
                append_to_name(all.back().name, setting);
            }
            if (!point.empty()) all.back().paper_seconds = 0;
        }
    return all;
}

Options options_of(const StudyRow& row, Options base) { return with_settings(std::move(base), row.settings); }

}  // namespace tress
