// SPDX-License-Identifier: MIT
// The command as a user meets it: pictures come out, and bad input is refused in one line, soon, with little memory,
// leaving nothing behind.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/plan.h"
#include "io/exr_file.h"
#include "tests/run_command.h"
#include "tools/check/support/sanitizers.h"

using namespace tress;
using namespace tress::test;
using Json = nlohmann::json;

namespace {

const char* const kSmallScene = R"({
  "camera": {"from": [0, 0, 60], "to": [0, 0, 0], "fov": 30, "size": [32, 32]},
  "hair": [{"groom": "wavy", "segments": 2000}],
  "meshes": [{"sphere": {"center": [0, 0, 0], "radius": 6}, "albedo": [0.5, 0.4, 0.3]}],
  "lights": [{"type": "point", "position": [20, 30, 40], "intensity": [2000, 2000, 2000]}],
  "options": {"spp": 2, "photons": {"count": 5000}}
})";

/// One line on stderr, exit code 2, under a second of work and 100 MB.
void check_refused(const CommandResult& r) {
    CAPTURE(r.error);
    CHECK(r.exit_code == 2);
    CHECK(std::count(r.error.begin(), r.error.end(), '\n') == 1);
    CHECK(r.error.rfind("tress: ", 0) == 0);
    CHECK(r.output.empty());
    if (kSanitized) return;
    CHECK(r.cpu_seconds < 1);
    CHECK(r.peak_megabytes < 100);
}

std::string hair_header(uint32_t strands, uint32_t points, uint32_t arrays, uint32_t segments) {
    std::string header(128, '\0');
    std::memcpy(header.data(), "HAIR", 4);
    const uint32_t words[] = {strands, points, arrays, segments};
    std::memcpy(header.data() + 4, words, sizeof words);
    const float defaults[] = {0.1f, 0, 1, 1, 1};
    std::memcpy(header.data() + 20, defaults, sizeof defaults);
    return header;
}

/// Two strands of two points.
std::string small_hair(float x) {
    std::string file = hair_header(2, 4, 2, 1);
    const float points[] = {0, 0, 0, 0, 10, 0, x, 0, 0, 5, 10, 0};
    return file + std::string(reinterpret_cast<const char*>(points), sizeof points);
}

std::string scene_of(const std::string& hair_file) {
    return R"({"hair": [{"file": ")" + hair_file + R"("}], "camera": {"size": [8, 8]}, "options": {"spp": 1}})";
}

}  // namespace

TEST_CASE("render writes an EXR with layers, a PNG beside it, and figures") {
    const Folder folder;
    const std::string scene = write_bytes(folder.file("scene.json"), kSmallScene), exr = folder.file("a.exr");
    const CommandResult r = run_tress({"render", scene, "-o", exr, "--stats", folder.file("s.json"), "--quiet"});
    CAPTURE(r.error);
    REQUIRE(r.exit_code == 0);
    CHECK(r.error.empty());
    CHECK(read_bytes(folder.file("a.png")).substr(1, 3) == "PNG");

    const LayeredImage picture = read_exr(exr);
    CHECK(picture.width == 32);
    for (const char* name : {"", "type1", "variance", "depth", "albedo"})
        CHECK(
            std::any_of(picture.layers.begin(), picture.layers.end(), [&](const Layer& l) { return l.name == name; }));
    CHECK(std::any_of(picture.metadata.begin(), picture.metadata.end(),
                      [](const auto& entry) { return entry.first == "tress.options.spp" && entry.second == "2"; }));

    const Json stats = Json::parse(read_bytes(folder.file("s.json")));
    for (const char* key : {"seconds", "stages", "left_out", "types", "spp", "threads", "isa", "peak_rss_bytes",
                            "segments", "dropped_segments", "options"})
        CHECK(stats.contains(key));
    double percent = 0;
    for (const Json& type : stats["types"]) percent += type["percent"].get<double>();
    CHECK(percent == doctest::Approx(100));
    for (const char* key : {"load", "build", "render", "total"}) CHECK(stats["seconds"][key].get<double>() >= 0);
    CHECK(stats["spp"] == 2);
}

TEST_CASE("--fiber changes the hair's colour, and contradictions are said in one line") {
    const Folder folder;
    const std::string scene = write_bytes(folder.file("scene.json"), kSmallScene), exr = folder.file("a.exr");
    const auto albedo = [&](const std::string& fiber) {
        REQUIRE(run_tress({"render", scene, "-o", exr, "--quiet", "--fiber", fiber}).exit_code == 0);
        const LayeredImage picture = read_exr(exr);
        double sum = 0;
        for (const Layer& layer : picture.layers)
            if (layer.name == "albedo")
                for (const float v : layer.data) sum += double(v);
        return sum;
    };
    CHECK(albedo("eumelanin=8") < albedo("eumelanin=0.1"));
    CHECK(run_tress({"plan", scene, "--reference", "--scattering", "full"}).exit_code == 0);
    const CommandResult r = run_tress({"plan", scene, "--scattering", "full"});
    CHECK(r.exit_code == 2);
    CHECK(r.error.find("scattering: 'full' with type1") != std::string::npos);
    for (const char* bad : {"photons.count=-1", "photons.count=1e30", "photons.radius=nan", "gather.rays=0"})
        CHECK(run_tress({"plan", scene, "--set", bad}).exit_code == 2);
}

TEST_CASE("maps of shadows are options like others, and auto says what it expected and what it took") {
    const Folder folder;
    const std::string scene = write_bytes(folder.file("scene.json"), kSmallScene), exr = folder.file("a.exr");
    const char* const methods[] = {"deep", "opacity", "clusters"};
    for (int kind = 0; kind < kMapKinds; ++kind) {
        const char* type1 = methods[kind];
        CAPTURE(type1);
        const CommandResult r = run_tress({"render", scene, "-o", exr, "--quiet", "--type1", type1, "--type3",
                                           std::string("ray+") + type1, "--stats", folder.file("a.json")});
        CAPTURE(r.error);
        REQUIRE(r.exit_code == 0);
        const auto stages = nlohmann::json::parse(read_bytes(folder.file("a.json")))["stages"];
        CHECK(std::any_of(stages.begin(), stages.end(),
                          [&](const auto& row) { return row["name"] == stage::kShadowMaps[kind]; }));
    }
    const CommandResult chosen = run_tress({"render", scene, "-o", exr, "--type1", "auto"});
    CHECK(chosen.exit_code == 0);
    CHECK(chosen.error.find("type 1: by shadow rays, estimated") != std::string::npos);
    for (const char* bad : {"maps.resolution=0", "maps.resolution=1e9", "maps.grid=17", "maps.near=-1",
                            "deep.error=nan", "opacity.layers=0", "clusters.count=65", "type3=deep"})
        check_refused(run_tress({"plan", scene, "--set", bad}));
}

TEST_CASE("type2 auto says what it expected and what it took") {
    const Folder folder;
    const std::string scene = write_bytes(folder.file("scene.json"), kSmallScene);
    const CommandResult r =
        run_tress({"render", scene, "-o", folder.file("a.exr"), "--type2", "auto", "--stats", folder.file("a.json")});
    REQUIRE(r.exit_code == 0);
    CHECK(r.error.find("type 2: by rays, estimated") != std::string::npos);
    CHECK(nlohmann::json::parse(read_bytes(folder.file("a.json")))["type2_estimate"].is_object());
}

TEST_CASE("show sets layers and sums of layers side by side") {
    const Folder folder;
    const std::string scene = write_bytes(folder.file("scene.json"), kSmallScene), exr = folder.file("a.exr");
    const std::string png = folder.file("s.png");
    REQUIRE(run_tress({"render", scene, "-o", exr, "--quiet"}).exit_code == 0);
    const CommandResult r =
        run_tress({"show", exr, "-o", png, "--panel", "type1", "--panel", "type1+type2+type3", "--panel", "depth"});
    CAPTURE(r.error);
    REQUIRE(r.exit_code == 0);
    CHECK(uint8_t(read_bytes(png)[19]) == 3 * 32);  // low byte of the width
    REQUIRE(run_tress({"show", exr, exr, "-o", png, "--panel", "type1", "--panel", "depth"}).exit_code == 0);
    CHECK(uint8_t(read_bytes(png)[19]) == 4 * 32);
    REQUIRE(run_tress({"show", exr, "-o", png}).exit_code == 0);
    CHECK(read_bytes(png) == read_bytes(folder.file("a.png")));
    check_refused(run_tress({"show", exr, "-o", png, "--panel", "type9"}));
    check_refused(run_tress({"show", exr, "-o", folder.file("none/s.png")}));
    check_refused(run_tress({"show", exr, "-o", png, "--exposure", "nan"}));
}

TEST_CASE("a lamp that polygons enclose leaves hair dark, and it is said") {
    const Folder folder;
    const std::string scene = write_bytes(folder.file("scene.json"), R"({
  "camera": {"from": [0, 0, 60], "to": [0, 0, 0], "fov": 30, "size": [16, 16]},
  "hair": [{"groom": "wavy", "segments": 2000}],
  "meshes": [{"sphere": {"center": [20, 0, 20], "radius": 3}}],
  "lights": [{"type": "point", "position": [20, 0, 20], "intensity": [2000, 2000, 2000]},
             {"type": "point", "position": [0, 0, 0], "intensity": [2000, 2000, 2000]}],
  "options": {"spp": 2, "type4": "photons", "type5": "photons", "photons": {"count": 2000}}
})");
    const CommandResult r = run_tress({"render", scene, "-o", folder.file("a.exr"), "--stats", folder.file("s.json")});
    CHECK(r.exit_code == 0);
    CHECK(r.error.find("light 0 (point): none of its") != std::string::npos);
    CHECK(r.error.find("light 1 (point)") == std::string::npos);
    const LayeredImage picture = read_exr(folder.file("a.exr"));
    for (const Layer& layer : picture.layers)
        for (const float v : layer.data) CHECK(std::isfinite(v));
    CHECK(Json::parse(read_bytes(folder.file("s.json")))["photons"]["lights"][0]["met_hair"] == 0);
}

TEST_CASE("figures and plan name the same stages") {
    const Folder folder;
    const std::string scene = write_bytes(folder.file("scene.json"), kSmallScene);
    const CommandResult plan = run_tress({"plan", scene, "--json"});
    REQUIRE(plan.exit_code == 0);
    const CommandResult r =
        run_tress({"render", scene, "-o", folder.file("a.exr"), "--stats", folder.file("s.json"), "--quiet"});
    REQUIRE(r.exit_code == 0);
    const Json planned = Json::parse(plan.output), stats = Json::parse(read_bytes(folder.file("s.json")));
    CHECK(planned["left_out"] == stats["left_out"]);
    for (const Json& stage : stats["stages"]) {
        const auto same_name = [&](const Json& item) { return item["name"] == stage["name"]; };
        CAPTURE(stage.dump());
        CHECK(std::any_of(planned["stages"].begin(), planned["stages"].end(), same_name));
        CHECK(std::none_of(planned["left_out"].begin(), planned["left_out"].end(), same_name));
    }
}

TEST_CASE("pixels do not depend on the number of threads, and scalar code repeats itself") {
    const Folder folder;
    const std::string scene = write_bytes(folder.file("scene.json"), kSmallScene);
    const auto pixels = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"render", scene, "-o", folder.file("a.exr"), "--quiet"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        REQUIRE(run_tress(arguments).exit_code == 0);
        std::vector<std::vector<float>> data;
        for (const Layer& layer : read_exr(folder.file("a.exr")).layers) data.push_back(layer.data);
        return data;
    };
    const auto reference = pixels({"--threads", "1"});
    CHECK(pixels({"--threads", "2"}) == reference);
    CHECK(pixels({"--isa", "scalar"}) == reference);
    CHECK(pixels({"--seed", "1"}) != reference);
}

TEST_CASE("a file of NaN points renders what is left and counts what was dropped") {
    const Folder folder;
    write_bytes(folder.file("nan.hair"), small_hair(NAN));
    const std::string scene = write_bytes(folder.file("scene.json"), scene_of("nan.hair"));
    const CommandResult r =
        run_tress({"render", scene, "-o", folder.file("a.exr"), "--stats", folder.file("s.json"), "--quiet"});
    CAPTURE(r.error);
    REQUIRE(r.exit_code == 0);
    const Json stats = Json::parse(read_bytes(folder.file("s.json")));
    CHECK(stats["segments"] == 1);
    CHECK(stats["dropped_segments"] == 1);
}

TEST_CASE("bad hair files are refused") {
    const std::string good = small_hair(1);
    const std::pair<const char*, std::string> bad[] = {
        {"truncated", good.substr(0, good.size() - 1)},
        {"header only", good.substr(0, 100)},
        {"empty", ""},
        {"counts of 2^32-1", hair_header(0xffffffff, 0xffffffff, 31, 0xffffffff)},
        {"counts that multiply past 2^32", hair_header(0x10000, 0x55555556, 2, 65535)},
        {"zero strands", hair_header(0, 0, 2, 1)},
        {"no magic", "RIAH" + good.substr(4)},
        {"points that do not add up", hair_header(2, 5, 2, 1) + std::string(60, '\0')},
    };
    for (const auto& [what, content] : bad) {
        CAPTURE(what);
        const Folder folder;
        write_bytes(folder.file("bad.hair"), content);
        const std::string scene = write_bytes(folder.file("scene.json"), scene_of("bad.hair"));
        const CommandResult r = run_tress({"render", scene, "-o", folder.file("a.exr"), "--quiet"});
        check_refused(r);
        CHECK(r.error.find("bad.hair") != std::string::npos);
        CHECK(folder.entries() == 2);  // nothing left behind
    }
}

TEST_CASE("bad scenes, meshes and pictures are refused") {
    const Folder folder;
    write_bytes(folder.file("good.hair"), small_hair(1));
    write_bytes(folder.file("index.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    write_bytes(folder.file("liar.ply"),
                "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\n"
                "property float y\nproperty float z\nelement face 4000000000\n"
                "property list uchar int vertex_indices\nend_header\nshort");
    write_bytes(folder.file("text.exr"), "this is not an EXR file");
    const std::string hair = R"("hair": [{"file": "good.hair"}])";
    const std::pair<std::string, const char*> bad[] = {
        {R"({"hiar": []})", "hair"},
        {"{" + hair + R"(, "camera": {"fovv": 3}})", "fov"},
        {"{" + hair + R"(, "camera": {"fov": "wide"}})", "fov"},
        {"{" + hair + R"(, "options": {"sppp": 3}})", "spp"},
        {"{" + hair + R"(, "options": {"spp": 0}})", "spp"},
        {"{" + hair + R"(, "lights": [{"type": "lamp"}]})", "lamp"},
        {"{" + hair, "scene.json"},
        {"", "scene.json"},
        {"{}", "hair"},
        {R"({"hair": [{"file": "none.hair"}]})", "none.hair"},
        {R"({"hair": [{"file": "."}]})", "scene.json"},
        {R"({"meshes": [{"file": "index.obj"}]})", "index.obj"},
        {R"({"meshes": [{"file": "liar.ply"}]})", "liar.ply"},
        {"{" + hair + R"(, "lights": [{"type": "environment", "file": "text.exr"}]})", "text.exr"},
        {R"({"hair": [{"groom": "wavvy"}]})", "wavy"},
    };
    for (const auto& [text, named] : bad) {
        CAPTURE(text);
        const std::string scene = write_bytes(folder.file("scene.json"), text);
        const CommandResult r = run_tress({"render", scene, "-o", folder.file("a.exr"), "--quiet"});
        check_refused(r);
        if (std::strcmp(named, "scene.json") != 0) CHECK(r.error.find(named) != std::string::npos);
        CHECK_FALSE(std::filesystem::exists(folder.file("a.exr")));
    }
}

TEST_CASE("bad usage is refused") {
    const Folder folder;
    const std::string scene = write_bytes(folder.file("scene.json"), kSmallScene), exr = folder.file("a.exr");
    write_bytes(folder.file("plain"), "a file where a folder should be");
    const std::vector<std::vector<std::string>> bad = {
        {},
        {"rendre"},
        {"render", scene},
        {"render", scene, "-o", exr, "--spp", "0"},
        {"render", scene, "-o", exr, "--spp", "many"},
        {"render", scene, "-o", exr, "--sppp", "4"},
        {"render", scene, "-o", exr, "--size", "0x5"},
        {"render", scene, "-o", exr, "--size", "99999999999x5"},
        {"render", scene, "-o", exr, "--size", "32768x32768"},
        {"render", scene, "-o", exr, "--isa", "altivec"},
        {"render", scene, "-o", exr, "--type1", "magic"},
        {"render", scene, "-o", exr, "--set", "accel.bin=3"},
        {"render", scene, "-o", exr, "--set", "spp"},
        {"render", scene, "-o", folder.file("plain/a.exr")},
        {"render", scene, "-o", folder.file("no/such/folder/a.exr")},
        {"render", scene, "-o", folder.file("a.jpeg")},
        {"render", scene, "-o", exr, "--stats", folder.file("plain/s.json")},
        {"render", folder.file("none.json"), "-o", exr},
        {"info", folder.file("none.hair")},
        {"info", folder.file("")},
        {"groom", "mohawk", "-o", folder.file("m.hair")},
        {"groom", "wavy", "-o", folder.file("plain/m.hair")},
        {"compare", folder.file("none.exr"), folder.file("none.exr")},
        {"compare", scene, scene},
        {"trace", "--segments", scene, "--rays", scene, "--query", "nearest"},
    };
    for (const auto& arguments : bad) {
        std::string line;
        for (const std::string& argument : arguments) line += argument + " ";
        CAPTURE(line);
        check_refused(run_tress(arguments));
        CHECK(folder.entries() == 2);
    }
}

TEST_CASE("groom, info and compare work on what the others write") {
    const Folder folder;
    const std::string hair = folder.file("w.hair"), scene = write_bytes(folder.file("scene.json"), kSmallScene);
    REQUIRE(run_tress({"groom", "wavy", "-o", hair, "--segments", "5000"}).exit_code == 0);
    const CommandResult info = run_tress({"info", hair, "--json"});
    REQUIRE(info.exit_code == 0);
    const Json counts = Json::parse(info.output);
    for (const char* key : {"strands", "points", "segments", "triangles", "bounds", "radius"})
        CHECK(counts.contains(key));
    CHECK(counts["segments"].get<int>() > 4900);

    const std::string a = folder.file("a.exr"), b = folder.file("b.exr");
    REQUIRE(run_tress({"render", scene, "-o", a, "--quiet"}).exit_code == 0);
    REQUIRE(run_tress({"render", scene, "-o", b, "--quiet", "--seed", "7"}).exit_code == 0);
    const Json same = Json::parse(run_tress({"compare", a, a, "--json"}).output);
    const Json other = Json::parse(run_tress({"compare", a, b, "--json", "--diff", folder.file("d.png")}).output);
    CHECK(same["relmse"] == 0);
    CHECK(same["flip"] == 0);
    CHECK(other["relmse"] > 0);
    CHECK(other["flip"] > 0);
    CHECK(std::filesystem::exists(folder.file("d.png")));
}

TEST_CASE("options that may be given more than once take one value each, whatever stands behind it") {
    const Folder folder;
    const std::string scene = write_bytes(folder.file("scene.json"), kSmallScene);
    const CommandResult r =
        run_tress({"plan", "--set", "gather.rays=2", "--fiber", "eumelanin=1", "--set", "spp=3", scene});
    CAPTURE(r.error);
    CHECK(r.exit_code == 0);
    CHECK(r.output.find("2000 segments") != std::string::npos);
}
