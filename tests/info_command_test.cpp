// SPDX-License-Identifier: MIT
#include <sys/wait.h>

#include <cstdio>

#include "io/hair_file.h"
#include "tests/io_support.h"

using namespace tress;
using namespace tress::test;

namespace {

/// What the command prints, on both of its outputs, and the status it ends with.
struct Run {
    std::string text;
    int status = -1;
};

Run run_info(const std::string& arguments) {
    Run run;
    std::FILE* pipe = popen((std::string(TRESS_COMMAND) + " info " + arguments + " 2>&1").c_str(), "r");
    REQUIRE(pipe != nullptr);
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) run.text += char(c);
    run.status = WEXITSTATUS(pclose(pipe));
    return run;
}

}  // namespace

TEST_CASE("info says what a hair file, a mesh file and a scene of both hold") {
    const Folder folder;
    HairFile hair;
    hair.strands.first = {0, 3};
    for (int p = 0; p < 3; ++p) hair.strands.add_point({0, float(p), 0});
    hair.strands.constant_radius = 0.125f;
    write_hair_file(folder.file("a.hair"), hair);
    write_bytes(folder.file("a.obj"), "v 0 0 4\nv 1 0 4\nv 0 1 4\nf 1 2 3\n");
    write_bytes(folder.file("a.json"), R"({"hair": [{"file": "a.hair"}], "meshes": [{"file": "a.obj"}]})");

    const Run of_hair = run_info(folder.file("a.hair") + " --json");
    CHECK(of_hair.status == 0);
    for (const char* part : {"\"strands\": 1", "\"points\": 3", "\"segments\": 2", "\"triangles\": 0"})
        CHECK(contains(of_hair.text, part));
    const Run of_mesh = run_info(folder.file("a.obj") + " --json");
    CHECK(of_mesh.status == 0);
    CHECK(contains(of_mesh.text, "\"triangles\": 1"));
    const Run of_scene = run_info(folder.file("a.json"));
    CAPTURE(of_scene.text);
    CHECK(of_scene.status == 0);
    for (const char* part :
         {"segments          2\n", "triangles         1\n", "[[0.0,0.0,0.0],[1.0,2.0,4.0]]", "[0.125,0.125]"})
        CHECK(contains(of_scene.text, part));
}

TEST_CASE("info ends with 2 and one line for a bad file") {
    const Folder folder;
    for (const std::string& file :
         {folder.file("none.hair"), folder.path(), write_bytes(folder.file("a.exr"), "text")}) {
        const Run run = run_info(file);
        CAPTURE(run.text);
        CHECK(run.status == 2);
        CHECK(run.text.find('\n') == run.text.size() - 1);
    }
}
