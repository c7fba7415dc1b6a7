// SPDX-License-Identifier: MIT
// Words and numbers of a text, line by line; the same in every locale. Messages name the file and the line.
#pragma once

#include <string>
#include <string_view>

namespace tress {

class TextScanner {
public:
    /// `text` must outlive the scanner. `line` is the number of its first line.
    TextScanner(std::string path, std::string_view text, size_t line = 1)
        : path_(std::move(path)), rest_(text), line_(line) {}

    /// Goes to the start of the next line; false at the end of the text. To be called before the first word, too.
    bool next_line();
    /// The next word of this line; empty where there is none left.
    std::string_view word();
    /// What is left of this line.
    std::string_view rest_of_line() const { return in_line_; }
    size_t line() const { return line_; }
    /// The next word of any line; empty at the end of the text.
    std::string_view word_anywhere();

    double number(std::string_view word) const;
    long long whole_number(std::string_view word) const;

    [[noreturn]] void fail(const std::string& problem) const;

private:
    std::string path_;
    std::string_view rest_, in_line_;
    size_t line_;
    bool started_ = false;
};

/// `text` for a message: cut where it is long, and on one line.
std::string in_quotes(std::string_view text);

}  // namespace tress
