// SPDX-License-Identifier: MIT
// The file of a study: JSON, a line each of what was measured, and of what follows from it. What was measured is found
// again by its key, so that no study does it twice.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tress {

using Json = nlohmann::ordered_json;

class StudyLog {
public:
    /// Reads the lines that were measured; a file that is not there is empty. Throws InputError, with the line, where
    /// the file is not a study's.
    explicit StudyLog(std::string path);

    /// The measured line with this key, or nullptr.
    const Json* find(const std::string& key) const;

    /// Keeps a line that was measured, {"line": ..., "key": ..., ...}, in place of one with its key. The file is
    /// replaced, whole.
    void add(Json line);

    /// Replaces the file: `header` first, then all that was measured, then `derived`.
    void write(const Json& header, const std::vector<Json>& derived) const;

private:
    std::string path_;
    std::vector<Json> measured_;
};

/// A whole file as JSON. Throws InputError.
Json read_json(const std::string& path);

}  // namespace tress
