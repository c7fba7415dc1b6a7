// SPDX-License-Identifier: MIT
// Values of a JSON file with their place in it, read as what they should be. What is not so throws InputError with the
// place ("scene.json: hair[0].radius"), what was found and what was expected.
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "core/math.h"
#include "io/json_tree.h"

namespace tress {

/// Largest size of a number: its square still fits into a float's range where that counts, and a float holds it.
inline constexpr double kLargestNumber = 1e30;

class JsonValue {
public:
    /// The root of `file`; both must outlive this and all that comes from it.
    JsonValue(const JsonNode& node, const std::string& file) : node_(&node), file_(&file) {}

    /// "scene.json: hair[0].radius".
    std::string where() const { return place_.empty() ? *file_ : *file_ + ": " + place_; }
    [[noreturn]] void fail(const std::string& problem) const;

    /// Throws unless this is an object with no other keys than `known`.
    void check_keys(std::initializer_list<const char*> known) const;
    /// The value of `key` in this object.
    std::optional<JsonValue> find(const std::string& key) const;
    JsonValue at(const std::string& key) const;
    bool has(const std::string& key) const { return node_->find(key) != nullptr; }
    /// Which of `keys` this object has: exactly one.
    std::string only_one_of(std::initializer_list<const char*> keys) const;

    /// All values of an object, or of an array.
    std::vector<JsonValue> members() const;
    std::vector<JsonValue> elements() const;
    std::vector<JsonValue> elements(size_t count) const;

    double number(double lowest = -kLargestNumber, double highest = kLargestNumber) const;
    long long whole_number(long long lowest, long long highest) const;
    const std::string& text() const;
    DVec3 vector() const;                                               // three numbers
    Rgb rgb(double lowest = 0, double highest = kLargestNumber) const;  // three numbers
    DVec3 direction() const;                                            // three numbers, not all 0

    const JsonNode& node() const { return *node_; }
    const std::string& key() const { return key_; }

private:
    JsonValue(const JsonNode& node, const JsonValue& parent, std::string place, std::string key)
        : node_(&node), file_(parent.file_), place_(std::move(place)), key_(std::move(key)) {}
    JsonValue member(size_t item) const;
    [[noreturn]] void fail_kind(const std::string& expected) const;

    const JsonNode* node_;
    const std::string* file_;
    std::string place_, key_;
};

}  // namespace tress
