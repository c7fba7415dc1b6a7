// SPDX-License-Identifier: MIT
#include "io/ply_file.h"

#include <array>
#include <limits>

#include "core/error.h"
#include "io/ply_header.h"
#include "io/polygons.h"
#include "io/strand_data.h"
#include "io/text_scanner.h"

namespace tress {
namespace {

/// Numbers after the header, one after the other, from text or from bytes.
class Body {
public:
    Body(ByteReader& file, const PlyHeader& header)
        : file_(file),
          is_text_(header.format == PlyFormat::ascii),
          text_(is_text_ ? file.read_rest() : std::string()),
          words_(file.path(), text_, header.lines + 1) {
        file_.order = header.format == PlyFormat::big_endian ? std::endian::big : std::endian::little;
    }

    double number(PlyType type) {
        if (is_text_) return words_.number(words_.word_anywhere());
        switch (type) {
            case PlyType::i8:
                return file_.read<int8_t>("a value");
            case PlyType::u8:
                return file_.read<uint8_t>("a value");
            case PlyType::i16:
                return file_.read<int16_t>("a value");
            case PlyType::u16:
                return file_.read<uint16_t>("a value");
            case PlyType::i32:
                return file_.read<int32_t>("a value");
            case PlyType::u32:
                return file_.read<uint32_t>("a value");
            case PlyType::f32:
                return file_.read<float>("a value");
            case PlyType::f64:
                break;
        }
        return file_.read<double>("a value");
    }

    /// Throws where `count` values of `type` cannot follow. A value in a text takes two bytes with its blank.
    void need(uint64_t count, PlyType type, const char* what) const {
        if (!is_text_) return file_.need(count, bytes(type), what);
        if (count > (text_.size() + 1) / 2)
            fail(std::to_string(count) + " " + what + ", expected no more than fit into the " +
                 std::to_string(text_.size()) + " bytes of text");
    }
    void need_rows(const PlyElement& element) const {
        uint64_t row = 0;
        for (const PlyProperty& p : element.properties) row += is_text_ ? 2 : bytes(p.list_length.value_or(p.type));
        if (!is_text_) return file_.need(element.count, row, element.name.c_str());
        if (row > 0 && element.count > (text_.size() + 1) / row)
            fail(std::to_string(element.count) + " of element " + element.name +
                 ", expected no more than fit into the " + std::to_string(text_.size()) + " bytes of text");
    }

    [[noreturn]] void fail(const std::string& problem) const {
        if (is_text_) words_.fail(problem);
        file_.fail(problem);
    }

private:
    ByteReader& file_;
    bool is_text_;
    std::string text_;
    TextScanner words_;
};

/// A whole number from 0 to `largest`.
uint64_t whole(const Body& body, double value, double largest, const char* what) {
    if (!(value >= 0 && value <= largest && value == std::floor(value)))
        body.fail(std::string(what) + " " + std::to_string(value) + ", expected a whole number from 0 to " +
                  std::to_string(uint64_t(largest)));
    return uint64_t(value);
}

uint64_t list_length(Body& body, const PlyProperty& property) {
    constexpr double kMost = std::numeric_limits<uint32_t>::max();
    const uint64_t length = whole(body, body.number(*property.list_length), kMost, "a list's length");
    body.need(length, property.type, "items of a list");
    return length;
}

void skip_list(Body& body, const PlyProperty& property) {
    for (uint64_t n = list_length(body, property); n > 0; --n) body.number(property.type);
}

void skip_element(Body& body, const PlyElement& element) {
    if (element.properties.empty()) return;
    for (uint64_t i = 0; i < element.count; ++i) {
        for (const PlyProperty& property : element.properties) {
            if (property.list_length)
                skip_list(body, property);
            else
                body.number(property.type);
        }
    }
}

void read_vertices(Body& body, const PlyElement& element, TriangleMesh& mesh) {
    if (mesh.vertices() > 0) body.fail("a second element vertex, expected one");
    std::array<int, 6> place;  // of x, y, z, nx, ny, nz
    const char* const names[] = {"x", "y", "z", "nx", "ny", "nz"};
    for (size_t k = 0; k < place.size(); ++k) place[k] = element.find(names[k]);
    for (size_t k = 0; k < 3; ++k)
        if (place[k] < 0 || element.properties[size_t(place[k])].list_length)
            body.fail(std::string("vertices without ") + names[k] + ", expected x, y and z");
    const bool has_normals = place[3] >= 0 && place[4] >= 0 && place[5] >= 0;
    std::vector<double> row(element.properties.size());
    for (uint64_t v = 0; v < element.count; ++v) {
        for (size_t p = 0; p < row.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            if (property.list_length)
                skip_list(body, property);
            else
                row[p] = body.number(property.type);
        }
        const auto value = [&](size_t k) { return float(row[size_t(place[k])]); };
        mesh.add_vertex({value(0), value(1), value(2)});
        if (has_normals) mesh.normal.emplace_back(value(3), value(4), value(5));
    }
}

void read_faces(Body& body, const PlyElement& element, TriangleMesh& mesh) {
    int corners = element.find("vertex_indices");
    if (corners < 0) corners = element.find("vertex_index");
    if (corners < 0 || !element.properties[size_t(corners)].list_length)
        body.fail("faces without a list vertex_indices, expected one");
    if (mesh.vertices() == 0) body.fail("faces before any vertex, expected vertices first");
    const double last = double(mesh.vertices() - 1);
    std::vector<uint32_t> polygon;
    for (uint64_t f = 0; f < element.count; ++f) {
        for (size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            if (!property.list_length) {
                body.number(property.type);
            } else if (p != size_t(corners)) {
                skip_list(body, property);
            } else {
                polygon.resize(list_length(body, property));
                for (uint32_t& corner : polygon)
                    corner = uint32_t(whole(body, body.number(property.type), last, "vertex"));
                add_polygon(mesh, polygon);
            }
        }
    }
}

}  // namespace

TriangleMesh read_ply_file(const std::string& path) {
    ByteReader file(path);
    const PlyHeader header = read_ply_header(file);
    Body body(file, header);
    TriangleMesh mesh;
    for (const PlyElement& element : header.elements) {
        body.need_rows(element);
        if (element.name == "vertex") {
            check_point_count(path, element.count);
            read_vertices(body, element, mesh);
        } else if (element.name == "face") {
            read_faces(body, element, mesh);
        } else {
            skip_element(body, element);
        }
    }
    finish_mesh(path, mesh);
    return mesh;
}

}  // namespace tress
