// SPDX-License-Identifier: MIT
#include "io/obj_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <unordered_map>

#include "io/byte_reader.h"
#include "io/polygons.h"
#include "io/text_scanner.h"

#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

namespace tress {
namespace {

constexpr uint32_t kNoNormal = std::numeric_limits<uint32_t>::max();
/// Positions and normals fit into 32 bits each: the shortest line of one ("v 0 0 0") has 8 bytes.
constexpr uint64_t kLargestFile = uint64_t(8) * kNoNormal;

/// What the library is given: the lines of vertices, normals and faces. It takes words that are no numbers for 0 and
/// believes the counts of tags, so words are checked here and all other lines are left out.
struct CheckedLines {
    std::string text;
    std::vector<size_t> face_line;  // where each face stands in the file
};

void check_numbers(TextScanner& in) {
    for (int component = 0; component < 3; ++component) {
        const std::string_view word = in.word();
        if (!std::isfinite(in.number(word))) in.fail(in_quotes(word) + ", expected a finite number");
    }
}

/// An index as the library can hold it.
void check_index(const TextScanner& in, std::string_view word) {
    const long long index = in.whole_number(word);
    constexpr long long largest = std::numeric_limits<int>::max();
    if (index < -largest || index > largest) in.fail(in_quotes(word) + ", expected a whole number of 32 bits");
}

/// Words are "position", "position/texture", "position//normal" or "position/texture/normal".
void check_face(TextScanner& in) {
    size_t corners = 0;
    for (std::string_view word = in.word(); !word.empty(); word = in.word(), ++corners) {
        const size_t slash = word.find('/');
        check_index(in, word.substr(0, slash));
        const size_t second = slash == std::string_view::npos ? slash : word.find('/', slash + 1);
        if (second != std::string_view::npos && second + 1 < word.size()) check_index(in, word.substr(second + 1));
    }
    if (corners < 3) in.fail("a face of " + std::to_string(corners) + " corners, expected 3 or more");
}

/// Lines end where the library takes them to: at a carriage return alone, too.
void end_lines_alike(std::string& text) {
    for (size_t at = text.find('\r'); at != std::string::npos; at = text.find('\r', at + 1))
        text[at] = at + 1 < text.size() && text[at + 1] == '\n' ? ' ' : '\n';
}

CheckedLines checked_lines(const std::string& path, std::string& text) {
    end_lines_alike(text);
    // A backslash joins lines. The line number is then off by one, which no file seen minds.
    for (size_t at = text.find("\\\n"); at != std::string::npos; at = text.find("\\\n", at)) text.replace(at, 2, "  ");
    CheckedLines lines;
    TextScanner in(path, text);
    while (in.next_line()) {
        const std::string_view line = in.rest_of_line(), kind = in.word();
        if (kind == "v" || kind == "vn")
            check_numbers(in);
        else if (kind == "f")
            check_face(in), lines.face_line.push_back(in.line());
        else
            continue;
        lines.text.append(line).push_back('\n');
    }
    return lines;
}

/// A corner of a face: 0-based position and normal.
struct Corner {
    uint32_t position, normal;
};

/// The file as it is: corners of all faces, one after the other. Filled by the library's callbacks.
struct ObjData {
    const std::string& path;
    const std::vector<size_t>& face_line;
    std::vector<Vec3> position{}, normal{};
    std::vector<Corner> corner{};
    std::vector<uint32_t> corners_of_face{};

    /// 1 is the first, -1 the last so far.
    uint32_t resolved(long long index, size_t count, const char* what) const {
        const auto n = static_cast<long long>(count);
        if (index >= 1 && index <= n) return uint32_t(index - 1);
        if (index <= -1 && index >= -n) return uint32_t(n + index);
        TextScanner(path, {}, face_line[corners_of_face.size()])
            .fail(std::string(what) + " " + std::to_string(index) + " of a face, expected 1 to " + std::to_string(n) +
                  ", as many as there are so far, or -" + std::to_string(n) + " to -1");
    }
};

void parse(const std::string& text, ObjData& obj) {
    tinyobj::callback_t callback;
    callback.vertex_cb = [](void* user, double x, double y, double z, double) {
        static_cast<ObjData*>(user)->position.emplace_back(DVec3(x, y, z));
    };
    callback.normal_cb = [](void* user, double x, double y, double z) {
        static_cast<ObjData*>(user)->normal.emplace_back(DVec3(x, y, z));
    };
    callback.index_cb = [](void* user, tinyobj::index_t* indices, int count) {
        ObjData& data = *static_cast<ObjData*>(user);
        for (const tinyobj::index_t& index : std::span(indices, size_t(count))) {
            const uint32_t position = data.resolved(index.vertex_index, data.position.size(), "vertex");
            const bool has_normal = index.normal_index != 0;  // the library's word for none
            data.corner.push_back(
                {position, has_normal ? data.resolved(index.normal_index, data.normal.size(), "normal") : kNoNormal});
        }
        data.corners_of_face.push_back(uint32_t(count));
    };
    std::istringstream in(text);
    tinyobj::LoadObjWithCallback(in, callback, &obj);
}

/// Numbers the distinct (position, normal) pairs in the order of their first use.
class Vertices {
public:
    Vertices(const ObjData& obj, TriangleMesh& mesh, bool keep_normals)
        : obj_(obj), mesh_(mesh), keep_normals_(keep_normals) {}

    uint32_t index_of(const Corner& corner) {
        const uint32_t normal = keep_normals_ ? corner.normal : 0;
        const auto [place, is_new] =
            index_.try_emplace(uint64_t(corner.position) << 32 | normal, uint32_t(mesh_.vertices()));
        if (is_new) {
            mesh_.add_vertex(obj_.position[corner.position]);
            if (keep_normals_) mesh_.normal.push_back(obj_.normal[normal]);
        }
        return place->second;
    }

private:
    const ObjData& obj_;
    TriangleMesh& mesh_;
    bool keep_normals_;
    std::unordered_map<uint64_t, uint32_t> index_;
};

}  // namespace

TriangleMesh read_obj_file(const std::string& path) {
    std::string text = read_text_file(path, kLargestFile);
    const CheckedLines lines = checked_lines(path, text);
    ObjData obj{path, lines.face_line};
    parse(lines.text, obj);
    const bool all_have_normals =
        std::all_of(obj.corner.begin(), obj.corner.end(), [](const Corner& c) { return c.normal != kNoNormal; });
    TriangleMesh mesh;
    Vertices vertices(obj, mesh, all_have_normals);
    std::vector<uint32_t> polygon;
    size_t next = 0;
    for (const uint32_t corners : obj.corners_of_face) {
        polygon.clear();
        for (uint32_t k = 0; k < corners; ++k) polygon.push_back(vertices.index_of(obj.corner[next++]));
        add_polygon(mesh, polygon);
    }
    finish_mesh(path, mesh);
    return mesh;
}

}  // namespace tress
