// SPDX-License-Identifier: MIT
#include "io/json_tree.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "io/byte_reader.h"
#include "io/text_scanner.h"

namespace tress {
namespace {

using Kind = JsonNode::Kind;

constexpr size_t kDeepest = 64;  // levels: what walks the tree may recurse
constexpr uint64_t kLargestFile = 4 << 20;
constexpr size_t kMostKeys = 1000;  // of one object: looked through one by one
constexpr size_t kLongestDetail = 200;

/// "line 3, column 5" of the byte before `offset`.
std::string place_in(const std::string& text, size_t offset) {
    const size_t end = std::min(offset > 0 ? offset - 1 : 0, text.size());
    const auto line = std::count(text.begin(), text.begin() + std::ptrdiff_t(end), '\n') + 1;
    const size_t break_before = end > 0 ? text.rfind('\n', end - 1) : std::string::npos;
    const size_t column = break_before == std::string::npos ? end + 1 : end - break_before;
    return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// Receives the parser's events and builds the tree; its member functions are the ones nlohmann::json asks for.
class Builder {
public:
    Builder(const std::string& path, const std::string& text) : path_(path), text_(text) {}

    bool null() { return add({}); }
    bool boolean(bool value) { return add({Kind::boolean, value ? "true" : "false", {}, {}}); }
    bool number_integer(int64_t value) { return add({Kind::number, std::to_string(value), {}, {}}); }
    bool number_unsigned(uint64_t value) { return add({Kind::number, std::to_string(value), {}, {}}); }
    bool number_float(double, std::string written) {
        for (char& c : written)  // the parser puts the locale's decimal point here
            if (std::string_view("0123456789+-eE").find(c) == std::string_view::npos) c = '.';
        return add({Kind::number, std::move(written), {}, {}});
    }
    bool string(std::string& value) { return add({Kind::text, std::move(value), {}, {}}); }
    bool binary(std::vector<uint8_t>&) { return false; }  // of other formats than text

    bool start_object(size_t) { return open(Kind::object); }
    bool start_array(size_t) { return open(Kind::array); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }
    bool key(std::string& name) {
        std::vector<std::string>& keys = open_.back()->keys;
        if (std::find(keys.begin(), keys.end(), name) != keys.end())
            throw InputError(path_, "the key " + in_quotes(name) + " stands twice in one object, expected once");
        if (keys.size() == kMostKeys)
            throw InputError(path_, "an object of more than " + std::to_string(kMostKeys) + " keys, expected fewer");
        keys.push_back(std::move(name));
        return true;
    }
    bool parse_error(size_t offset, const std::string&, const nlohmann::json::exception& error) {
        const std::string what = error.what();
        const size_t end_of_id = what.find("] ");
        std::string detail = what.substr(end_of_id == std::string::npos ? 0 : end_of_id + 2);
        const size_t end_of_place = detail.find(": ");  // the parser's own place is the same as ours
        if (detail.rfind("parse error", 0) == 0 && end_of_place != std::string::npos) detail.erase(0, end_of_place + 2);
        for (char& c : detail)
            if (c < ' ' || c > '~') c = '?';
        if (detail.size() > kLongestDetail) detail = detail.substr(0, kLongestDetail) + "...";
        throw InputError(path_ + ": " + place_in(text_, offset), "no JSON: " + detail);
    }

    JsonNode take() { return std::move(root_); }

private:
    bool add(JsonNode node) {
        if (open_.empty())
            root_ = std::move(node);
        else
            open_.back()->items.push_back(std::move(node));
        return true;
    }
    bool open(Kind kind) {
        if (open_.size() == kDeepest)
            throw InputError(path_, "nested deeper than " + std::to_string(kDeepest) + " levels, expected less");
        add({kind, {}, {}, {}});
        // The parent does not grow while its last item is open, so the address stays good.
        open_.push_back(open_.empty() ? &root_ : &open_.back()->items.back());
        return true;
    }
    bool close() {
        open_.pop_back();
        return true;
    }

    const std::string &path_, &text_;
    JsonNode root_;
    std::vector<JsonNode*> open_;
};

}  // namespace

const JsonNode* JsonNode::find(const std::string& key) const {
    const auto found = std::find(keys.begin(), keys.end(), key);
    return found == keys.end() ? nullptr : &items[size_t(found - keys.begin())];
}

JsonNode read_json_file(const std::string& path) {
    const std::string text = read_text_file(path, kLargestFile);
    Builder builder(path, text);
    nlohmann::json::sax_parse(text, &builder);
    return builder.take();
}

}  // namespace tress
