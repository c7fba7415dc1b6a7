// SPDX-License-Identifier: MIT
#include "tools/check/rows/hostile_system.h"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>

#include "core/rng.h"
#include "io/checkpoint_file.h"
#include "io/exr_file.h"
#include "io/hair_file.h"
#include "io/mesh_file.h"
#include "io/png_file.h"
#include "io/scene_file.h"
#include "io/whole_file.h"
#include "tools/check/check_report.h"
#include "tools/check/support/decimal_commas.h"
#include "tools/check/support/folder.h"
#include "tools/check/support/full_disk.h"
#include "tools/check/support/refusal.h"
#include "tools/number_text.h"

namespace tress {
namespace {

using namespace test;

// --- Decimal commas.

const char* const kScene = R"({"camera": {"from": [0.5, 20.25, 60.125], "fov": 30.5, "size": [64, 64]},
 "hair": [{"groom": "wavy", "segments": 1000, "radius": 0.004, "radius_scale": 1.5,
   "fiber": {"eumelanin": 1.3, "beta_m": 0.3}}],
 "meshes": [{"quad": [[0.5,0,0],[1.5,0,0],[1,1.25,0],[0,1,0]], "albedo": [0.5, 0.25, 0.125]}],
 "lights": [{"type": "point", "position": [1.5, 2.5, 3.5], "intensity": [1e3, 1.5e3, 2.5e-3]}],
 "options": {"cutoff": 0.001, "film": {"exposure": 1.5}}})";
const char* const kObj = "v 0.5 0 0\nv 1.5 0.25 0\nv 1 1.125 1e-3\nf 1 2 3\n";
const char* const kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0.5 0 0\n1.5 0.25 0\n1 1.125 1e-3\n3 0 1 2\n";

/// Numbers that were read, and texts that numbers were written to.
struct ReadAndWritten {
    std::vector<double> numbers;
    std::vector<std::string> texts;
};

void read_scene(const std::string& path, ReadAndWritten& to) {
    SceneDescription scene = read_scene_file(path);
    const Camera& camera = scene.camera;
    for (const double v : {camera.from.x, camera.from.y, camera.from.z, camera.fov}) to.numbers.push_back(v);
    for (const float v : {*scene.hair.at(0).radius, scene.hair[0].radius_scale, scene.hair[0].fiber.parameters.beta_m,
                          scene.meshes.at(0).albedo.y, scene.options.cutoff, scene.options.film.exposure})
        to.numbers.push_back(double(v));
    to.numbers.push_back(std::get<PointLight>(scene.lights.at(0)).position.y);
    to.texts.push_back(options_text(scene.options));
}

void read_mesh(const std::string& path, ReadAndWritten& to) {
    const TriangleMesh mesh = read_mesh_file(path);
    for (const auto* axis : {&mesh.x, &mesh.y, &mesh.z})
        to.numbers.insert(to.numbers.end(), axis->begin(), axis->end());
}

ReadAndWritten read_and_write(const Folder& folder) {
    ReadAndWritten all;
    read_scene(write_bytes(folder.file("a.json"), kScene), all);
    read_mesh(write_bytes(folder.file("a.obj"), kObj), all);
    read_mesh(write_bytes(folder.file("a.ply"), kPly), all);
    Options options;
    set_option(options, "--set", "accel.empty_bonus", "0.375");
    all.numbers.push_back(double(options.accel.empty_bonus));
    for (const OptionField& field : option_fields(options)) all.texts.push_back(accepted(field));
    all.texts.push_back(message_of([&] { set_option(options, "--set", "film.exposure", "40.5"); }));
    all.texts.push_back(message_of([] { make_fiber({.beta_m = 1.5f}); }));
    all.texts.push_back(significant(1234.5, 5) + " " + significant(1.25e-9, 3));
    const CheckedRow row{{"D0", "case", "expected", nullptr}, {{at_most("figure", 0.25, 1.5, "%")}, {}}, {}, 12345.5};
    all.texts.push_back(to_text(row));
    all.texts.push_back(to_json({"", "", "", 1, {row}}).dump());
    return all;
}

template <class T>
size_t differences(const std::vector<T>& a, const std::vector<T>& b) {
    size_t different = a.size() != b.size();
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) different += a[i] != b[i];
    return different;
}

void add_commas(std::vector<Figure>& figures) {
    const Folder folder;
    const ReadAndWritten with_points = read_and_write(folder);
    ReadAndWritten with_commas;
    std::string locale;
    {
        const DecimalCommas commas;
        with_commas = read_and_write(folder);
        locale = commas.installed().empty() ? "of C++ streams alone: none is installed" : commas.installed();
    }
    const std::string under = " under decimal commas (" + locale + ")";
    figures.push_back(exactly("numbers read otherwise, of " + std::to_string(with_points.numbers.size()) + under,
                              double(differences(with_points.numbers, with_commas.numbers)), 0));
    figures.push_back(exactly("texts written otherwise, of " + std::to_string(with_points.texts.size()) + under,
                              double(differences(with_points.texts, with_commas.texts)), 0));
}

// --- Files that cannot be written.

using Writer = std::function<void(const std::string& path)>;

/// Writers of every kind of file, none below a few kilobytes.
std::vector<Writer> writers() {
    constexpr int kSide = 64;
    Image picture = make_image(kSide, kSide);
    for (size_t i = 0; i < picture.pixel.size(); ++i) picture.pixel[i] = Rgb(random(1, i), random(2, i), random(3, i));
    LayeredImage layers{kSide, kSide, {{"", {"R", "G", "B"}, {}}}, {}};
    for (const Rgb& p : picture.pixel) layers.layers[0].data.insert(layers.layers[0].data.end(), {p.x, p.y, p.z});
    HairFile hair;
    for (uint32_t i = 0; i < kSide * kSide; ++i) hair.strands.add_point({float(i), 1, 2});
    hair.strands.first = {0, kSide * kSide};
    Plan plan{};
    plan.types[0] = true;
    const Film film = make_film(kSide, kSide, plan);
    return {[=](const std::string& path) { write_exr(path, layers); },
            [=](const std::string& path) { write_png(path, picture); },
            [=](const std::string& path) { write_hair_file(path, hair); },
            [=](const std::string& path) {
                write_checkpoint(path, {"scene=0\n", 1, 1, {}}, film);
            },
            [=](const std::string& path) { write_text_file(path, std::string(kSide * kSide, 'x')); }};
}

/// A read-only folder too, but for users whom no permission holds.
void add_unwritable_places(std::vector<Figure>& figures) {
    const Folder folder;
    const std::string plain = write_bytes(folder.file("plain"), "x"), closed = folder.file("closed");
    std::filesystem::create_directory(closed);
    std::vector<std::string> places{folder.path(), folder.file("missing/a"), plain + "/a"};
    if (geteuid() != 0) {
        chmod(closed.c_str(), S_IRUSR | S_IXUSR);
        places.push_back(closed + "/a");
    }
    size_t tries = 0, refused = 0;
    for (const std::string& place : places) {
        refused += is_one_line(message_of([&] { check_writable(place); }));
        for (const Writer& write : writers()) refused += is_one_line(message_of([&] { write(place); }));
        tries += 1 + writers().size();
    }
    chmod(closed.c_str(), S_IRWXU);
    const bool nothing_left = folder.entries() == 2 && std::filesystem::is_empty(closed) && read_bytes(plain) == "x";
    figures.push_back(exactly("refused in one line, of " + std::to_string(tries) + " files in " +
                                  std::to_string(places.size()) + " places that cannot be written",
                              double(refused), double(tries)));
    figures.push_back(holds("nothing is left in those places", nothing_left));
}

void add_full_disk(std::vector<Figure>& figures) {
    constexpr rlim_t kRoom = 1000;  // bytes
    const Folder folder;
    const std::string path = write_bytes(folder.file("a"), "old");
    size_t refused = 0, harmed = 0;
    for (const Writer& write : writers()) {
        const FullDisk full(kRoom);
        refused += is_one_line(message_of([&] { write(path); }));
        harmed += read_bytes(path) != "old" || folder.entries() != 1;
    }
    const std::string of = ", of " + std::to_string(writers().size()) + " kinds of files on a full disk";
    figures.push_back(exactly("refused in one line" + of, double(refused), double(writers().size())));
    figures.push_back(exactly("half written, or the old file lost" + of, double(harmed), 0));
}

/// Writes half a file in a process of its own, which is killed then.
void write_half_and_die(const std::string& path) {
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no further process can be had");
    if (child == 0) {
        try {
            WholeFile file(path);
            file.write("half", 4);
            raise(SIGKILL);
        } catch (...) {
        }
        _exit(1);
    }
    int status = 0;
    waitpid(child, &status, 0);
}

void add_interrupt(std::vector<Figure>& figures) {
    const Folder folder;
    const std::string old = write_bytes(folder.file("old"), "old"), none = folder.file("none");
    write_half_and_die(old);
    write_half_and_die(none);
    figures.push_back(holds("killed while it writes: the old file stands, and no half of a new one",
                            read_bytes(old) == "old" && !std::filesystem::exists(none)));
}

}  // namespace

Outcome measure_hostile_system(const CheckSettings&) {
    std::vector<Figure> figures;
    add_commas(figures);
    add_unwritable_places(figures);
    add_full_disk(figures);
    add_interrupt(figures);
    return {figures, {}};
}

}  // namespace tress
