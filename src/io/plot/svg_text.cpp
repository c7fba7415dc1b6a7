// SPDX-License-Identifier: MIT
#include "io/plot/svg_text.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string_view>

namespace tress::svg {
namespace {

constexpr char32_t kEllipsis = 0x2026;

/// Of the UTF-8 sequence that starts at `from`: its code point and length; a broken one gives 0 and skips one byte.
std::pair<char32_t, size_t> decode(const std::string& text, size_t from) {
    const auto byte = [&](size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const unsigned lead = byte(from);
    if (lead < 0x80) return {lead, 1};
    const size_t length = lead >= 0xf8 ? 0 : lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : lead >= 0xc0 ? 2 : 0;
    if (length == 0) return {0, 1};
    char32_t c = lead & (0x7fu >> length);
    for (size_t i = 1; i < length; ++i) {
        if ((byte(from + i) & 0xc0) != 0x80) return {0, 1};
        c = c << 6 | (byte(from + i) & 0x3f);
    }
    constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
    return {c >= kLeast[length] ? c : 0, length};
}

bool is_printable(char32_t c) {
    const bool control = c < 0x20 || (c >= 0x7f && c < 0xa0);
    const bool surrogate = c >= 0xd800 && c < 0xe000;
    return !control && !surrogate && (c & 0xfffe) != 0xfffe && c < 0x110000;
}

/// The characters that XML and readers can take.
std::u32string printable(const std::string& text) {
    std::u32string kept;
    for (size_t i = 0; i < text.size();) {
        const auto [c, length] = decode(text, i);
        if (is_printable(c)) kept += c;
        i += length;
    }
    return kept;
}

/// A generous guess, in ems, for the usual sans-serif fonts.
double width_of(char32_t c) {
    constexpr std::u32string_view kNarrow = U"iljtfrI.,:;'|!()[] -/";
    constexpr std::u32string_view kWide = U"mwM+=<>~", kWidest = U"W%@";
    if (c >= 0x2e80) return 1.05;
    if (kNarrow.find(c) != std::u32string_view::npos) return 0.38;
    if (kWide.find(c) != std::u32string_view::npos) return 0.95;
    if (kWidest.find(c) != std::u32string_view::npos) return 1.05;
    return c >= 'A' && c <= 'Z' ? 0.72 : c < 0x80 ? 0.59 : 0.75;
}

double width_of(const std::u32string& text) {
    double width = 0;
    for (char32_t c : text) width += width_of(c);
    return width;
}

/// How many characters of `text` from `from` on make a line of `width` ems: up to a good place to break, if any.
size_t line_length(const std::u32string& text, size_t from, double width) {
    constexpr std::u32string_view kBreakAfter = U" -_/,;:";
    size_t fit = 0, good = 0;
    for (double used = 0; from + fit < text.size(); ++fit) {
        used += width_of(text[from + fit]);
        if (used > width && text[from + fit] != U' ') break;
        if (kBreakAfter.find(text[from + fit]) != std::u32string_view::npos) good = fit + 1;
    }
    if (from + fit == text.size()) return fit;
    return good > 0 ? good : std::max<size_t>(fit, 1);
}

/// `line` with an ellipsis, shortened to `width` ems.
std::u32string cut(std::u32string line, double width) {
    while (!line.empty() && width_of(line) + 1 > width) line.pop_back();
    return line + kEllipsis;
}

}  // namespace

std::string fixed(double v, int decimals) {
    char digits[400];
    const auto end = std::to_chars(digits, digits + sizeof digits, v, std::chars_format::fixed, decimals);
    return {digits, end.ptr};
}

std::string coord(double v) {
    std::string text = fixed(v, 2);
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string point(double x, double y) { return coord(x) + ' ' + coord(y); }

std::string escaped(const std::u32string& text) {
    std::string xml;
    for (char32_t c : text) {
        const bool special = c == '&' || c == '<' || c == '>' || c == '"' || c == '\'';
        if (special || c >= 0x7f)
            xml += "&#" + std::to_string(uint32_t(c)) + ';';
        else
            xml += char(c);
    }
    return xml;
}

std::string escaped(const std::string& text) { return escaped(printable(text)); }

std::vector<std::u32string> wrapped(const std::string& text, double width, double font, size_t most) {
    const std::u32string whole = printable(text);
    std::vector<std::u32string> lines;
    for (size_t from = 0; from < whole.size() && lines.size() < most;) {
        const size_t length = line_length(whole, from, width / font);
        const bool is_cut = lines.size() + 1 == most && from + length < whole.size();
        lines.push_back(is_cut ? cut(whole.substr(from), width / font) : whole.substr(from, length));
        from += length;
    }
    return lines;
}

std::string text_at(double x, double y, const char* kind, const std::string& content, const std::string& more) {
    return "<text class=\"" + std::string(kind) + "\" x=\"" + coord(x) + "\" y=\"" + coord(y) + '"' + more + '>' +
           content + "</text>\n";
}

std::string path(const char* kind, const std::string& d) {
    return "<path class=\"" + std::string(kind) + "\" d=\"" + d + "\"/>\n";
}

}  // namespace tress::svg
