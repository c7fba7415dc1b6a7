// SPDX-License-Identifier: MIT
#include "io/mesh_file.h"

#include <algorithm>
#include <bit>

#include "core/bounds.h"
#include "io/shape_mesh.h"
#include "tests/io_support.h"

using namespace tress;
using namespace tress::test;

namespace {

/// A .ply file of a square and a triangle, with an element and properties that no one asked for.
std::string ply_file(std::endian order, bool is_text) {
    const std::string format = is_text                        ? "ascii"
                               : order == std::endian::little ? "binary_little_endian"
                                                              : "binary_big_endian";
    std::string file = "ply\nformat " + format +
                       " 1.0\ncomment made for a test\nelement vertex 5\nproperty float x\nproperty double y\n"
                       "property short z\nproperty uchar red\nproperty list uchar int near\nelement edge 2\n"
                       "property int a\nproperty ushort b\nelement face 2\nproperty char flag\n"
                       "property list uint8 uint vertex_indices\nend_header\n";
    const auto add = [&](auto value) {
        if (is_text) {
            file += std::to_string(value) + " ";
            return;
        }
        char* const bytes = reinterpret_cast<char*>(&value);
        if (order != std::endian::native) std::reverse(bytes, bytes + sizeof value);
        append(file, value);
    };
    for (int v = 0; v < 5; ++v) {
        add(float(v) + 0.5f);
        add(double(v) - 0.25);
        add(int16_t(-v));
        add(uint8_t(200));
        add(uint8_t(2));
        add(int32_t(7));
        add(int32_t(8));
        if (is_text) file += "\n";
    }
    for (int e = 0; e < 2; ++e) {
        add(int32_t(e));
        add(uint16_t(e));
        if (is_text) file += "\n";
    }
    for (const std::vector<uint32_t>& face : {std::vector<uint32_t>{0, 1, 2, 3}, {2, 3, 4}}) {
        add(int8_t(-1));
        add(uint8_t(face.size()));
        for (const uint32_t corner : face) add(corner);
        if (is_text) file += "\n";
    }
    return file;
}

std::string obj_message(const Folder& folder, const std::string& text) {
    const std::string path = write_bytes(folder.file("bad.obj"), text);
    return message_of([&] { read_mesh_file(path); });
}

std::string ply_message(const Folder& folder, const std::string& bytes) {
    const std::string path = write_bytes(folder.file("bad.ply"), bytes);
    return message_of([&] { read_mesh_file(path); });
}

Bounds vertex_bounds(const TriangleMesh& mesh) {
    Bounds box;
    for (size_t v = 0; v < mesh.vertices(); ++v) box.add(mesh.vertex(v));
    return box;
}

}  // namespace

TEST_CASE("a .ply file is the same mesh as text and as bytes of either order") {
    const Folder folder;
    for (const std::string& bytes : {ply_file(std::endian::little, true), ply_file(std::endian::little, false),
                                     ply_file(std::endian::big, false)}) {
        const TriangleMesh mesh = read_mesh_file(write_bytes(folder.file("a.ply"), bytes));
        REQUIRE(mesh.vertices() == 5);
        CHECK(mesh.vertex(3) == Vec3(3.5f, 2.75f, -3));
        CHECK(mesh.corner == std::vector<uint32_t>{0, 1, 2, 0, 2, 3, 2, 3, 4});
        CHECK(mesh.normal.empty());
    }
}

TEST_CASE("a .ply file cut anywhere is refused") {
    const Folder folder;
    for (const bool is_text : {true, false}) {
        const std::string bytes = ply_file(std::endian::big, is_text);
        const size_t needed = bytes.find_last_not_of(" \n") + 1;
        for (size_t length = 0; length < needed - (is_text ? 1 : 0); ++length) {
            CAPTURE(length);
            CHECK(is_one_line(ply_message(folder, bytes.substr(0, length))));
        }
    }
}

TEST_CASE("a .ply header that lies is refused before anything is made for it") {
    const Folder folder;
    const auto file = [](const std::string& elements, const std::string& format = "ascii") {
        return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
    };
    const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
    const std::string list = "property list uchar int vertex_indices\n";
    const std::pair<std::string, std::string> bad[] = {
        {file("element vertex 4294967295\n" + xyz) + "0 0 0\n", "4294967295"},
        {file("element vertex 9223372036854775807\n" + xyz, "binary_little_endian"), "9223372036854775807"},
        {file("element vertex 99999999999999999999\n" + xyz), "expected a whole number"},
        {file("element vertex -1\n" + xyz), "none below 0"},
        {file("element vertex 1\nproperty float x\n") + "0\n", "vertices without y"},
        {file("element vertex 1\nproperty real x\n"), "expected a type"},
        {file("property float x\n"), "before any element"},
        {file("element face 1\n" + list) + "3 0 1 2\n", "faces before any vertex"},
        {file("element vertex 1\n" + xyz + "element face 1\n" + list) + "0 0 0\n3 0 0 1\n", "vertex 1.0"},
        {file("element vertex 1\n" + xyz + "element face 1\n" + list) + "0 0 0\n200 0 0 0\n", "items of a list"},
        {file("element vertex 1\n" + xyz) + "0 0 0\n", "no faces"},
        {file("element vertex 1\n" + xyz) + "0 zero 0\n", "'zero', expected a number"},
        {file("", "binary"), "expected ascii"},
        {"ply\nend_header\n", "format"},
        {"plywood", "byte"},
        {"solid", "no .ply file"},
        {"", "byte 0"},
    };
    for (const auto& [bytes, part] : bad) {
        const std::string message = ply_message(folder, bytes);
        CAPTURE(message);
        CAPTURE(part);
        CHECK(is_one_line(message));
        CHECK(contains(message, part));
    }
}

TEST_CASE("an element without properties costs nothing, however often it stands there") {
    const Folder folder;
    std::string bytes = ply_file(std::endian::little, true);
    bytes.insert(bytes.find("element face"), "element nothing 9000000000000000000\n");
    CHECK(read_mesh_file(write_bytes(folder.file("a.ply"), bytes)).triangles() == 3);
}

TEST_CASE("polygons of an .obj file are cut as fans, whatever way their corners are written") {
    const Folder folder;
    const TriangleMesh mesh = read_mesh_file(write_bytes(folder.file("a.obj"),
                                                         "# a comment\nmtllib none.mtl\n"
                                                         "v 0 0 0\nv 1 0 0 1\nv 1 1 0\r\nv +0.5 1.5e0 0\nv 0 1 0\n"
                                                         "vt 0 0\ng side\nf 1/1 2/1 3/1 \\\n 4/1 5/1\nf -5 -4 -3\n"));
    CHECK(mesh.corner == std::vector<uint32_t>{0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 1, 2});
    CHECK(mesh.vertex(3) == Vec3(0.5f, 1.5f, 0));
    CHECK(mesh.normal.empty());
}

TEST_CASE("lines of an .obj file may end in a carriage return alone, and faces in them are checked too") {
    const Folder folder;
    const TriangleMesh mesh = read_mesh_file(write_bytes(folder.file("a.obj"), "v 0 0 0\rv 1 0 0\rv 1 1 0\rf 1 2 3\r"));
    CHECK(mesh.corner == std::vector<uint32_t>{0, 1, 2});
    CHECK(contains(obj_message(folder, "v 0 0 0\rf 1 2 3\r"), "line 2: vertex 2"));
}

TEST_CASE("an .obj vertex with two normals becomes two, and normals become unit") {
    const Folder folder;
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 2\nvn 0 3 0\nvn 0 0 0\n";
    const TriangleMesh mesh =
        read_mesh_file(write_bytes(folder.file("a.obj"), vertices + "f 1//1 2//1 3//1\nf 1//2 2//1 3//3\n"));
    CHECK(mesh.corner == std::vector<uint32_t>{0, 1, 2, 3, 1, 4});
    CHECK(mesh.normal[0] == Vec3(0, 0, 1));
    CHECK(mesh.normal[3] == Vec3(0, 1, 0));
    CHECK(mesh.normal[4] == Vec3(0, 0, 1));  // had none: that of its triangle
    const TriangleMesh flat =
        read_mesh_file(write_bytes(folder.file("a.obj"), vertices + "f 1//1 2//1 3//1\nf 1 2 3\n"));
    CHECK(flat.normal.empty());
    CHECK(flat.vertices() == 3);
}

TEST_CASE("an .obj file with a fault is refused with the line it is in") {
    const Folder folder;
    const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const std::pair<std::string, std::string> bad[] = {
        {v + "f 1 2 4\n", "line 4: vertex 4 of a face, expected 1 to 3"},
        {v + "f 0 1 2\n", "vertex 0"},
        {v + "f -4 1 2\n", "vertex -4"},
        {v + "f 1//1 2 3\n", "normal 1 of a face, expected 1 to 0"},
        {v + "f 1 2 99999999999999999999\n", "expected a whole number"},
        {v + "f 1 2 4294967297\n", "expected a whole number of 32 bits"},
        {v + "f 1 2\n", "a face of 2 corners"},
        {v + "f a b c\n", "'a', expected a whole number"},
        {"v 0 0\n", "nothing, expected a number"},
        {"v 0 0 x\n", "'x', expected a number"},
        {v, "no faces"},
        {v + "v 1e39 0 0\nf 1 2 4\n", "vertex 3 is not finite"},
        {v + "v nan 0 0\nf 1 2 4\n", "line 4: 'nan', expected a finite number"},
        {"", "no faces"},
    };
    for (const auto& [text, part] : bad) {
        const std::string message = obj_message(folder, text);
        CAPTURE(message);
        CAPTURE(part);
        CHECK(is_one_line(message));
        CHECK(contains(message, part));
    }
}

TEST_CASE("a mesh file of an unknown kind says which are known") {
    CHECK(contains(message_of([] { read_mesh_file("a.stl"); }), "expected .obj or .ply"));
}

TEST_CASE("the sphere is closed, outward and nearly round") {
    const TriangleMesh mesh = sphere_mesh(2);
    std::vector<std::pair<uint32_t, uint32_t>> edges;
    double volume = 0;
    for (size_t t = 0; t < mesh.triangles(); ++t) {
        const auto [a, b, c] = mesh.triangle(t);
        volume += dot(DVec3(a), cross(DVec3(b), DVec3(c))) / 6;
        // Nowhere more than 0.1 % below the sphere: the middle of a face is its lowest point.
        CHECK(length(DVec3(a + b + c) / 3.0) > 2 * (1 - 1e-3));
        for (size_t k = 0; k < 3; ++k) edges.emplace_back(mesh.corner[3 * t + k], mesh.corner[3 * t + (k + 1) % 3]);
    }
    CHECK(std::abs(volume / (4.0 / 3 * 3.14159265358979 * 8) - 1) < 2e-3);
    std::sort(edges.begin(), edges.end());
    CHECK(std::adjacent_find(edges.begin(), edges.end()) == edges.end());
    size_t paired = 0;
    for (const auto& [a, b] : edges) paired += std::binary_search(edges.begin(), edges.end(), std::pair(b, a));
    CHECK(paired == edges.size());
}

TEST_CASE("real meshes have the counts and bounds that are known of them") {
    struct Known {
        const char* name;
        size_t triangles;  // 0: not known
        Vec3 lo, hi;
    };
    const Known files[] = {
        {"hair/digital-salon/head.obj", 21510, {-8.38f, -14.25f, -15.56f}, {8.38f, 14.15f, 5.98f}},
        {"hair/sintel/sintel.obj", 5952, {-19.74f, 2.54f, -10.14f}, {19.74f, 45.52f, 11.88f}},
        {"hair/sintel/sintel_eyeballs.obj", 1408, {0, 0, 0}, {0, 0, 0}},
        {"hair/tressfx-ponytail/ponytail_head.obj", 0, {-84.83f, -50.40f, -46.74f}, {81.95f, 119.98f, 47.55f}},
    };
    for (const Known& known : files) {
        const std::string name = known.name;
        CAPTURE(name);
        const auto path = real_file(known.name);
        if (!path) continue;
        const TriangleMesh mesh = read_mesh_file(*path);
        if (known.triangles) CHECK(mesh.triangles() == known.triangles);
        if (known.lo == known.hi) continue;
        const Bounds box = vertex_bounds(mesh);
        for (int axis = 0; axis < 3; ++axis) {
            CHECK(std::abs(box.lo[axis] - known.lo[axis]) < 0.0051f);
            CHECK(std::abs(box.hi[axis] - known.hi[axis]) < 0.0051f);
        }
    }
}
