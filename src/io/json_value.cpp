// SPDX-License-Identifier: MIT
#include "io/json_value.h"

#include <algorithm>

#include "core/error.h"
#include "core/nearest_name.h"
#include "core/shortest_text.h"
#include "io/text_scanner.h"

namespace tress {
namespace {

using Kind = JsonNode::Kind;

std::string found(const JsonNode& node) {
    switch (node.kind) {
        case Kind::null:
            return "null";
        case Kind::boolean:
            return node.text;
        case Kind::number:
            return node.text.substr(0, 40);
        case Kind::text:
            return in_quotes(node.text);
        case Kind::array:
            return "an array of " + std::to_string(node.items.size());
        case Kind::object:
            break;
    }
    return "an object";
}

/// A key for a message or a place in one.
std::string key_text(const std::string& key) {
    const std::string text = in_quotes(key);
    return key.empty() ? "''" : text.substr(1, text.size() - 2);
}

template <class T>
bool parse(const std::string& text, T& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

std::string listed(std::initializer_list<const char*> names, const char* last_joint) {
    std::string text;
    for (auto name = names.begin(); name != names.end(); ++name)
        text += std::string(name == names.begin() ? "" : name + 1 == names.end() ? last_joint : ", ") + *name;
    return text;
}

}  // namespace

void JsonValue::fail(const std::string& problem) const { throw InputError(where(), problem); }

void JsonValue::fail_kind(const std::string& expected) const { fail(found(*node_) + ", expected " + expected); }

JsonValue JsonValue::member(size_t item) const {
    const std::string& key = node_->keys[item];
    return {node_->items[item], *this, place_.empty() ? key_text(key) : place_ + "." + key_text(key), key};
}

void JsonValue::check_keys(std::initializer_list<const char*> known) const {
    if (node_->kind != Kind::object) fail_kind("an object {...}");
    const std::vector<std::string> names(known.begin(), known.end());
    for (size_t i = 0; i < node_->items.size(); ++i)
        if (std::find(names.begin(), names.end(), node_->keys[i]) == names.end())
            member(i).fail("unknown key, " + did_you_mean(node_->keys[i], names));
}

std::optional<JsonValue> JsonValue::find(const std::string& key) const {
    const JsonNode* value = node_->find(key);
    if (!value) return std::nullopt;
    return member(size_t(value - node_->items.data()));
}

JsonValue JsonValue::at(const std::string& key) const {
    const std::optional<JsonValue> value = find(key);
    if (!value) fail("no " + key + ", expected one");
    return *value;
}

std::string JsonValue::only_one_of(std::initializer_list<const char*> keys) const {
    std::string only;
    for (const char* key : keys) {
        if (!has(key)) continue;
        if (!only.empty()) fail("both " + only + " and " + key + ", expected one of " + listed(keys, " and "));
        only = key;
    }
    if (only.empty()) fail("none of " + listed(keys, " and ") + ", expected one of them");
    return only;
}

std::vector<JsonValue> JsonValue::members() const {
    if (node_->kind != Kind::object) fail_kind("an object {...}");
    std::vector<JsonValue> values;
    for (size_t i = 0; i < node_->items.size(); ++i) values.push_back(member(i));
    return values;
}

std::vector<JsonValue> JsonValue::elements() const {
    if (node_->kind != Kind::array) fail_kind("an array [...]");
    std::vector<JsonValue> values;
    for (size_t i = 0; i < node_->items.size(); ++i)
        values.push_back({node_->items[i], *this, place_ + "[" + std::to_string(i) + "]", {}});
    return values;
}

std::vector<JsonValue> JsonValue::elements(size_t count) const {
    if (node_->kind != Kind::array || node_->items.size() != count) fail_kind("an array of " + std::to_string(count));
    return elements();
}

double JsonValue::number(double lowest, double highest) const {
    double value = 0;
    const bool is_good =
        node_->kind == Kind::number && parse(node_->text, value) && value >= lowest && value <= highest;
    if (!is_good) fail_kind("a number from " + shortest_text(lowest) + " to " + shortest_text(highest));
    return value;
}

long long JsonValue::whole_number(long long lowest, long long highest) const {
    long long value = 0;
    const bool is_good =
        node_->kind == Kind::number && parse(node_->text, value) && value >= lowest && value <= highest;
    if (!is_good) fail_kind("a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest));
    return value;
}

const std::string& JsonValue::text() const {
    if (node_->kind != Kind::text) fail_kind("a text in quotes");
    return node_->text;
}

DVec3 JsonValue::vector() const {
    const std::vector<JsonValue> v = elements(3);
    return {v[0].number(), v[1].number(), v[2].number()};
}

Rgb JsonValue::rgb(double lowest, double highest) const {
    const std::vector<JsonValue> v = elements(3);
    return Rgb(DVec3(v[0].number(lowest, highest), v[1].number(lowest, highest), v[2].number(lowest, highest)));
}

DVec3 JsonValue::direction() const {
    const DVec3 v = vector();
    if (v == DVec3(0)) fail("a direction of length 0, expected a longer one");
    return v;
}

}  // namespace tress
