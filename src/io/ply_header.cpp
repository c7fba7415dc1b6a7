// SPDX-License-Identifier: MIT
#include "io/ply_header.h"

#include "io/text_scanner.h"

namespace tress {
namespace {

constexpr uint64_t kLongestHeader = 1 << 20;  // bytes: a file without the line end_header is not read to its end

struct TypeName {
    const char *name, *other_name;
    uint64_t bytes;
};
constexpr TypeName kTypes[] = {{"char", "int8", 1},     {"uchar", "uint8", 1},   {"short", "int16", 2},
                               {"ushort", "uint16", 2}, {"int", "int32", 4},     {"uint", "uint32", 4},
                               {"float", "float32", 4}, {"double", "float64", 8}};  // in the order of PlyType

PlyType read_type(TextScanner& in) {
    const std::string_view word = in.word();
    for (size_t t = 0; t < std::size(kTypes); ++t)
        if (word == kTypes[t].name || word == kTypes[t].other_name) return PlyType(t);
    in.fail(in_quotes(word) + ", expected a type such as float or uchar");
}

PlyFormat read_format(TextScanner& in) {
    const std::string_view word = in.word();
    if (word == "ascii") return PlyFormat::ascii;
    if (word == "binary_little_endian") return PlyFormat::little_endian;
    if (word == "binary_big_endian") return PlyFormat::big_endian;
    in.fail(in_quotes(word) + ", expected ascii, binary_little_endian or binary_big_endian");
}

PlyElement read_element(TextScanner& in) {
    PlyElement element;
    element.name = in.word();
    const long long count = in.whole_number(in.word());
    if (count < 0) in.fail(std::to_string(count) + " elements, expected none below 0");
    element.count = uint64_t(count);
    return element;
}

PlyProperty read_property(TextScanner& in) {
    PlyProperty property;
    TextScanner ahead = in;
    if (ahead.word() == "list") {
        in.word();
        property.list_length = read_type(in);
        if (*property.list_length == PlyType::f32 || *property.list_length == PlyType::f64)
            in.fail("a list whose length is a float, expected a whole number");
    }
    property.type = read_type(in);
    property.name = in.word();
    return property;
}

/// The bytes of the header, up to and with "end_header" and its line's end.
std::string header_text(ByteReader& in) {
    std::string text(3, '\0'), line;
    in.read(std::span(text), "header");
    if (text != "ply") in.fail("no .ply file, expected its first line to be ply");
    while (line != "end_header" && line != "end_header\r") {
        line.clear();
        for (char c = in.read<char>("header"); c != '\n'; c = in.read<char>("header")) {
            line += c;
            if (in.offset() > kLongestHeader) in.fail("no line end_header so far, expected one");
        }
        text += line + "\n";
    }
    return text;
}

}  // namespace

uint64_t bytes(PlyType type) { return kTypes[size_t(type)].bytes; }

int PlyElement::find(const std::string& wanted) const {
    for (size_t p = 0; p < properties.size(); ++p)
        if (properties[p].name == wanted) return int(p);
    return -1;
}

PlyHeader read_ply_header(ByteReader& file) {
    const std::string text = header_text(file);
    PlyHeader header;
    TextScanner in(file.path(), text);
    bool has_format = false;
    while (in.next_line()) {
        ++header.lines;
        const std::string_view key = in.word();
        if (key == "format") {
            header.format = read_format(in);
            has_format = true;
        } else if (key == "element") {
            header.elements.push_back(read_element(in));
        } else if (key == "property") {
            if (header.elements.empty()) in.fail("a property before any element");
            header.elements.back().properties.push_back(read_property(in));
        } else if (key != "ply" && key != "comment" && key != "obj_info" && key != "end_header" && !key.empty()) {
            in.fail(in_quotes(key) + ", expected format, element, property, comment or end_header");
        }
    }
    if (!has_format) in.fail("no line that starts with format, expected one");
    return header;
}

}  // namespace tress
