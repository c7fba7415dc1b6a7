// SPDX-License-Identifier: MIT
#include "tools/study/study_log.h"

#include <filesystem>
#include <fstream>

#include "core/error.h"
#include "io/whole_file.h"

namespace tress {

StudyLog::StudyLog(std::string path) : path_(std::move(path)) {
    if (!std::filesystem::exists(path_)) return;
    std::ifstream in(path_);
    if (!in) throw InputError(path_, "cannot be read");
    int number = 0;
    for (std::string text; std::getline(in, text);) {
        ++number;
        Json line = Json::parse(text, nullptr, false);
        if (!line.is_object() || !line.contains("line"))
            throw InputError(path_ + ": line " + std::to_string(number),
                             "no line of a study, expected {\"line\": ...}");
        if (line.contains("key")) measured_.push_back(std::move(line));
    }
}

const Json* StudyLog::find(const std::string& key) const {
    for (const Json& line : measured_)
        if (line["key"] == key) return &line;
    return nullptr;
}

void StudyLog::add(Json line) {
    std::erase_if(measured_, [&](const Json& old) { return old["key"] == line["key"]; });
    measured_.push_back(std::move(line));
    write({}, {});
}

void StudyLog::write(const Json& header, const std::vector<Json>& derived) const {
    std::string text;
    const auto add = [&](const Json& line) {
        text += line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    };
    if (!header.is_null()) add(header);
    for (const Json& line : measured_) add(line);
    for (const Json& line : derived) add(line);
    write_text_file(path_, text);
}

Json read_json(const std::string& path) {
    std::ifstream in(path);
    Json json = Json::parse(in, nullptr, false);
    if (json.is_discarded()) throw InputError(path, "no JSON, expected a file that tress wrote");
    return json;
}

}  // namespace tress
