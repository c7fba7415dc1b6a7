// SPDX-License-Identifier: MIT
#include "tests/fuzz/seeds.h"

#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/options.h"
#include "io/checkpoint_file.h"
#include "io/exr_file.h"
#include "io/hair_file.h"

namespace tress::fuzz {
namespace {

class Folder {
public:
    Folder(const std::string& parent, const char* target) : path_(std::filesystem::path(parent) / target) {
        std::filesystem::create_directories(path_);
    }
    std::string file(const char* name) const { return (path_ / name).string(); }
    void write(const char* name, const std::string& bytes) const {
        std::ofstream(file(name), std::ios::binary) << bytes;
    }

private:
    std::filesystem::path path_;
};

template <class T>
void append(std::string& bytes, std::initializer_list<T> values) {
    for (const T value : values) bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

HairFile small_hair() {
    HairFile hair;
    hair.strands.first = {0, 3, 5};
    for (int i = 0; i < 5; ++i) hair.strands.add_point(Vec3(float(i), float(i * i), -1));
    hair.strands.constant_radius = 0.05f;
    return hair;
}

void hair_seeds(const Folder& folder) {
    HairFile hair = small_hair();
    write_hair_file(folder.file("points"), hair);
    hair.strands.radius = {0.1f, 0.1f, 0.05f, 0.1f, 0.02f};
    hair.transparency = {0, 0, 0.5f, 0, 1};
    hair.strands.color.assign(5, Rgb(0.5f, 0.3f, 0.1f));
    hair.info = "a seed";
    write_hair_file(folder.file("all"), hair);
}

void data_seeds(const Folder& folder) {
    std::string bytes;
    append<int32_t>(bytes, {2, 3});
    append<float>(bytes, {0, 0, 0, 0, 1, 0, 0, 2, 0});
    append<int32_t>(bytes, {1});
    append<float>(bytes, {1, 1, 1});
    folder.write("two", bytes);
}

void tfx_seeds(const Folder& folder) {
    std::string three;
    append<float>(three, {3});
    append<uint32_t>(three, {1, 2});
    three.resize(296);
    append<float>(three, {0, 0, 0, 0, 1, 0});
    folder.write("version3", three);
    std::string four;
    append<float>(four, {4});
    append<uint32_t>(four, {1, 2, 160, 0, 0, 192, 196});
    four.resize(160);
    append<float>(four, {0, 0, 0, 1, 0, 1, 0, 1, 0.1f, 1, 0, 0, 1, 0, 1, 0, 1});
    folder.write("version4", four);
}

void obj_seeds(const Folder& folder) {
    folder.write("square",
                 "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\no square\ng a\ns 1\n"
                 "f 1/1/1 2/1/1 3/1/1 4/1/1\nf -4 -3 -2\n");
}

void ply_seeds(const Folder& folder) {
    const std::string elements =
        " 1.0\ncomment seed\nelement vertex 3\nproperty float x\nproperty double y\nproperty short z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    folder.write("text", "ply\nformat ascii" + elements + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    std::string binary = "ply\nformat binary_little_endian" + elements;
    for (const auto& [x, y] : {std::pair(0.f, 0.0), std::pair(1.f, 0.0), std::pair(0.f, 1.0)}) {
        append<float>(binary, {x});
        append<double>(binary, {y});
        append<int16_t>(binary, {0});
    }
    append<uint8_t>(binary, {3});
    append<int32_t>(binary, {0, 1, 2});
    folder.write("binary", binary);
}

void scene_seeds(const Folder& folder) {
    folder.write("lights",
                 R"({"camera": {"from": [0, 0, 60], "to": [0, 0, 0], "up": [0, 1, 0], "fov": 30, "size": [8, 8]},
"hair": [{"groom": "wavy", "segments": 2000, "fiber": {"color": [0.5, 0.3, 0.1], "beta_m": 0.3}}],
"meshes": [{"sphere": {"center": [0, 0, 0], "radius": 6}, "albedo": [0.5, 0.4, 0.3]}],
"lights": [{"type": "point", "position": [20, 30, 40], "intensity": [2, 2, 2]},
{"type": "distant", "direction": [0, -1, 0], "irradiance": [1, 1, 1]},
{"type": "environment", "radiance": [1, 1, 1], "rotation": 30}],
"options": {"spp": 2, "type2": "projection", "photons": {"count": 5000}, "accel": {"clip": false}}})");
    folder.write("files", R"({"hair": [{"file": "a.hair", "scale": 2, "translate": [0, 1, 0], "radius": 0.01}],
"meshes": [{"file": "head.obj"}], "lights": [{"type": "environment", "file": "sky.exr"}]})");
}

void environment_seeds(const Folder& folder) {
    LayeredImage sky{4, 2, {{"", {"R", "G", "B", "A"}, std::vector<float>(4 * 2 * 4, 0.5f)}}, {}};
    write_exr(folder.file("sky"), sky);
    sky.layers.push_back({"depth", {"Z"}, std::vector<float>(4 * 2, 1.0f)});
    sky.metadata = {{"made", "for a test"}};
    write_exr(folder.file("layers"), sky);
}

void checkpoint_seeds(const Folder& folder) {
    write_checkpoint(folder.file("film"), {kCheckpointMadeBy, 3, 1.5, {1, 2}}, checkpoint_film());
}

void set_seeds(const Folder& folder) {
    folder.write("all", options_text({}));
    folder.write("few",
                 "spp=16\ntype2=projection\naccel.traversal_cost=1e2\naccel.clip=false\nseed=18446744073709551615\n");
}

}  // namespace

Film checkpoint_film() {
    Plan plan{};
    plan.types[0] = true;
    return make_film(3, 2, plan);
}

void write_seeds(const std::string& folder) {
    hair_seeds({folder, "hair"});
    data_seeds({folder, "data"});
    tfx_seeds({folder, "tfx"});
    obj_seeds({folder, "obj"});
    ply_seeds({folder, "ply"});
    scene_seeds({folder, "scene"});
    environment_seeds({folder, "environment"});
    checkpoint_seeds({folder, "checkpoint"});
    set_seeds({folder, "set"});
}

}  // namespace tress::fuzz
