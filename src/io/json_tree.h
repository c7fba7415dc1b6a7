// SPDX-License-Identifier: MIT
// A JSON file as a tree of values, numbers kept as they were written.
#pragma once

#include <string>
#include <vector>

namespace tress {

struct JsonNode {
    enum class Kind { null, boolean, number, text, array, object };

    Kind kind = Kind::null;
    std::string text;               // of a text; a number as written; "true" or "false"
    std::vector<JsonNode> items;    // of an array or object
    std::vector<std::string> keys;  // of an object: one an item

    /// The value of `key`, or nullptr.
    const JsonNode* find(const std::string& key) const;
};

/// Throws InputError, with line and column, where `path` is no JSON, repeats a key, nests deeper than 64 levels, has
/// more than 1000 keys in an object or is longer than 4 MB.
JsonNode read_json_file(const std::string& path);

}  // namespace tress
