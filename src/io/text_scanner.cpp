// SPDX-License-Identifier: MIT
#include "io/text_scanner.h"

#include <charconv>

#include "core/error.h"

namespace tress {
namespace {

constexpr std::string_view kBlanks = " \t\r\f\v";
constexpr size_t kLongestQuote = 40;

/// from_chars knows no leading plus sign; files do.
std::string_view without_plus(std::string_view word) {
    return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}

template <class T>
bool parse(std::string_view word, T& value) {
    const std::string_view text = without_plus(word);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

}  // namespace

bool TextScanner::next_line() {
    if (rest_.empty()) return in_line_ = {}, false;
    const size_t end = rest_.find('\n');
    in_line_ = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    line_ += started_;
    started_ = true;
    return true;
}

std::string_view TextScanner::word() {
    const size_t start = in_line_.find_first_not_of(kBlanks);
    if (start == std::string_view::npos) return in_line_ = {};
    in_line_.remove_prefix(start);
    const std::string_view found = in_line_.substr(0, in_line_.find_first_of(kBlanks));
    in_line_.remove_prefix(found.size());
    return found;
}

std::string_view TextScanner::word_anywhere() {
    std::string_view found = word();
    while (found.empty() && next_line()) found = word();
    return found;
}

double TextScanner::number(std::string_view word) const {
    double value = 0;
    if (!parse(word, value)) fail(in_quotes(word) + ", expected a number");
    return value;
}

long long TextScanner::whole_number(std::string_view word) const {
    long long value = 0;
    if (!parse(word, value)) fail(in_quotes(word) + ", expected a whole number");
    return value;
}

void TextScanner::fail(const std::string& problem) const {
    throw InputError(path_ + ": line " + std::to_string(line_), problem);
}

std::string in_quotes(std::string_view text) {
    if (text.empty()) return "nothing";
    std::string result = "'";
    for (const char c : text.substr(0, kLongestQuote)) result += c >= ' ' && c <= '~' ? c : '?';
    return result + (text.size() > kLongestQuote ? "...'" : "'");
}

}  // namespace tress
