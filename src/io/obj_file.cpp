// SPDX-License-Identifier: MIT
#include "io/obj_file.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "io/byte_reader.h"
#include "io/polygons.h"
#include "io/text_scanner.h"

namespace tress {
namespace {

constexpr uint32_t kNoNormal = std::numeric_limits<uint32_t>::max();
/// Positions and normals fit into 32 bits each: the shortest line of one ("v 0 0 0") has 8 bytes.
constexpr uint64_t kLargestFile = uint64_t(8) * kNoNormal;

/// A corner of a face: 0-based position and normal.
struct Corner {
    uint32_t position, normal;
};

/// The file as it is: corners of all faces, one after the other.
struct ObjText {
    std::vector<Vec3> position, normal;
    std::vector<Corner> corner;
    std::vector<uint32_t> corners_of_face;
};

Vec3 read_vector(TextScanner& in) {
    double v[3];
    for (double& component : v) component = in.number(in.word());
    return Vec3(DVec3(v[0], v[1], v[2]));
}

/// 1 is the first, -1 the last so far.
uint32_t resolved(const TextScanner& in, std::string_view text, size_t count, const char* what) {
    const long long index = in.whole_number(text);
    const auto n = static_cast<long long>(count);
    if (index >= 1 && index <= n) return uint32_t(index - 1);
    if (index <= -1 && index >= -n) return uint32_t(n + index);
    in.fail(std::string(what) + " " + std::to_string(index) + " of a face, expected 1 to " + std::to_string(n) +
            ", as many as there are so far, or -" + std::to_string(n) + " to -1");
}

/// "position", "position/texture", "position//normal" or "position/texture/normal".
Corner read_corner(const TextScanner& in, std::string_view text, const ObjText& obj) {
    const size_t slash = text.find('/');
    const size_t second = slash == std::string_view::npos ? slash : text.find('/', slash + 1);
    Corner corner{resolved(in, text.substr(0, slash), obj.position.size(), "vertex"), kNoNormal};
    if (second != std::string_view::npos && second + 1 < text.size())
        corner.normal = resolved(in, text.substr(second + 1), obj.normal.size(), "normal");
    return corner;
}

void read_face(TextScanner& in, ObjText& obj) {
    const size_t before = obj.corner.size();
    for (std::string_view word = in.word(); !word.empty(); word = in.word())
        obj.corner.push_back(read_corner(in, word, obj));
    const size_t corners = obj.corner.size() - before;
    if (corners < 3) in.fail("a face of " + std::to_string(corners) + " corners, expected 3 or more");
    obj.corners_of_face.push_back(uint32_t(corners));
}

ObjText read_lines(const std::string& path, std::string& text) {
    // A backslash joins lines. The line number is then off by one, which no file seen minds.
    for (size_t at = text.find("\\\n"); at != std::string::npos; at = text.find("\\\n", at)) text.replace(at, 2, "  ");
    ObjText obj;
    TextScanner in(path, text);
    while (in.next_line()) {
        const std::string_view kind = in.word();
        if (kind == "v")
            obj.position.push_back(read_vector(in));
        else if (kind == "vn")
            obj.normal.push_back(read_vector(in));
        else if (kind == "f")
            read_face(in, obj);
    }
    return obj;
}

/// Numbers the distinct (position, normal) pairs in the order of their first use.
class Vertices {
public:
    Vertices(const ObjText& obj, TriangleMesh& mesh, bool keep_normals)
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
    const ObjText& obj_;
    TriangleMesh& mesh_;
    bool keep_normals_;
    std::unordered_map<uint64_t, uint32_t> index_;
};

}  // namespace

TriangleMesh read_obj_file(const std::string& path) {
    std::string text = read_text_file(path, kLargestFile);
    const ObjText obj = read_lines(path, text);
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
