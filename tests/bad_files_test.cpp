// SPDX-License-Identifier: MIT
// Damaged files: a reader either reads them or throws InputError with one line, and holds little memory meanwhile.
#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <functional>
#include <new>

#include "core/rng.h"
#include "io/exr_file.h"
#include "io/hair_file.h"
#include "io/mesh_file.h"
#include "io/scene_file.h"
#include "io/strand_file.h"
#include "tests/io_support.h"
#include "tools/check/support/damaged_bytes.h"

namespace {

std::atomic<size_t> largest_allocation{0};

void* counted(size_t bytes) {
    if (bytes > largest_allocation) largest_allocation = bytes;
    if (void* memory = std::malloc(bytes ? bytes : 1)) return memory;
    throw std::bad_alloc();
}

}  // namespace

void* operator new(size_t bytes) { return counted(bytes); }
void* operator new[](size_t bytes) { return counted(bytes); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, size_t) noexcept { std::free(memory); }

using namespace tress;
using namespace tress::test;

namespace {

constexpr int kCases = 1500;  // a kind of file
/// The files are below 4 kB. Text grows most: a node of a JSON tree takes some 100 bytes for 2, and arrays double.
constexpr size_t kMostAllocated = size_t(4) << 20;
/// A picture of any size up to 64 MB is believed (exr_header.h): channels of it may be allocated.
constexpr size_t kMostAllocatedOfPicture = size_t(256) << 20;

/// Reads damaged copies of `bytes` as the file `name`.
void check_reader(const std::string& name, const std::string& bytes, size_t most_allocated,
                  const std::function<void(const std::string&)>& read) {
    const Folder folder;
    const std::string path = folder.file(name);
    CHECK(message_of([&] { read(write_bytes(path, bytes)); }).empty());
    int read_well = 0;
    for (int i = 0; i < kCases; ++i) {
        write_bytes(path, damaged(bytes, hash(bytes.size(), uint64_t(i))));
        largest_allocation = 0;
        std::string message = "read";
        try {
            read(path);
            ++read_well;
        } catch (const InputError& error) {
            message = error.what();
        }  // any other exception ends the test
        const size_t largest = largest_allocation;
        if (is_one_line(message) && largest <= most_allocated) continue;
        CAPTURE(i);
        CAPTURE(message);
        CAPTURE(largest);
        CHECK(false);
    }
    MESSAGE(name << ": " << read_well << " of " << kCases << " were still good");
}

std::string hair_bytes() {
    HairFile hair;
    hair.strands.first = {0, 4, 6, 16};
    for (int p = 0; p < 16; ++p) {
        hair.strands.add_point({float(p), 1, 2});
        hair.strands.radius.push_back(0.1f);
        hair.strands.color.emplace_back(0.5f);
        hair.transparency.push_back(0.5f);
    }
    const Folder folder;
    write_hair_file(folder.file("a.hair"), hair);
    return read_bytes(folder.file("a.hair"));
}

std::string data_bytes() {
    std::string bytes;
    append(bytes, int32_t(4));
    for (int32_t points = 2; points < 6; ++points) {
        append(bytes, points);
        for (int i = 0; i < 3 * points; ++i) append(bytes, float(i));
    }
    return bytes;
}

std::string tfx_bytes(float version) {
    std::string bytes;
    append(bytes, version);
    for (const uint32_t field : {4u, 8u, 160u, 0u, 0u, 160u, 160u}) append(bytes, field);
    bytes.resize(version < 4 ? 296 : 160);
    for (int i = 0; i < 4 * 8 * 4; ++i) append(bytes, float(i));
    return bytes;
}

std::string ply_bytes(const std::string& format) {
    std::string bytes = "ply\nformat " + format +
                        " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                        "property float nx\nproperty float ny\nproperty float nz\n"
                        "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
    if (format == "ascii") return bytes + "0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n4 0 1 2 3\n3 0 1 2\n";
    const bool is_big = format == "binary_big_endian";
    const auto add = [&](auto value) {
        append(bytes, value);
        if (is_big) std::reverse(bytes.end() - sizeof value, bytes.end());
    };
    for (int i = 0; i < 4 * 6; ++i) add(float(i % 5));
    for (const uint8_t corners : {4, 3}) {
        add(corners);
        for (int32_t c = 0; c < corners; ++c) add(c);
    }
    return bytes;
}

const char* const kObj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\nf 1/1/1 2/1/1 3/1/1 4/1/1\nf -4//-1 -3//1 -2//1\n"
    "usemtl a\ng b c\no d\ns 1\nl 1 2\n";

const char* const kScene = R"({"camera": {"from": [0, 20, 60], "fov": 30, "size": [512, 512]},
 "hair": [{"groom": "wavy", "segments": 1000, "radius": 0.004, "matrix": [1,0,0,0,0,1,0,0,0,0,1,0],
   "children": {"count": 8}, "fiber": {"model": "chiang", "eumelanin": 1.3, "beta_m": 0.3}}],
 "meshes": [{"quad": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "albedo": [0.5, 0.5, 0.5]}],
 "lights": [{"type": "point", "position": [1, 2, 3], "intensity": [1e3, 1e3, 1e3]}],
 "options": {"spp": 64, "accel": {"bins": 32, "clip": true}}})";

std::string exr_bytes() {
    LayeredImage image{16, 8, {{"", {"R", "G", "B"}, std::vector<float>(16 * 8 * 3, 0.5f)}}, {{"seed", "0"}}};
    const Folder folder;
    write_exr(folder.file("a.exr"), image);
    return read_bytes(folder.file("a.exr"));
}

void read_hair(const std::string& path) { read_strand_file(path); }
void read_mesh(const std::string& path) { read_mesh_file(path); }

}  // namespace

TEST_CASE("damaged .hair files") { check_reader("a.hair", hair_bytes(), kMostAllocated, read_hair); }
TEST_CASE("damaged .data files") { check_reader("a.data", data_bytes(), kMostAllocated, read_hair); }
TEST_CASE("damaged .tfx files") {
    check_reader("a.tfx", tfx_bytes(3), kMostAllocated, read_hair);
    check_reader("a.tfx", tfx_bytes(4), kMostAllocated, read_hair);
}
TEST_CASE("damaged .ply files") {
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"})
        check_reader("a.ply", ply_bytes(format), kMostAllocated, read_mesh);
}
TEST_CASE("damaged .obj files") { check_reader("a.obj", kObj, kMostAllocated, read_mesh); }
TEST_CASE("damaged scene files") {
    check_reader("a.json", kScene, kMostAllocated, [](const std::string& path) { read_scene_file(path); });
}
TEST_CASE("damaged .exr files") {
    check_reader("a.exr", exr_bytes(), kMostAllocatedOfPicture, [](const std::string& path) { read_exr(path); });
}
