// SPDX-License-Identifier: MIT
#include "io/hair_file.h"
#include "tests/io_support.h"
#include "tests/run_command.h"

using namespace tress;
using namespace tress::test;

TEST_CASE("info says what a hair file, a mesh file and a scene of both hold") {
    const Folder folder;
    HairFile hair;
    hair.strands.first = {0, 3};
    for (int p = 0; p < 3; ++p) hair.strands.add_point({0, float(p), 0});
    hair.strands.constant_radius = 0.125f;
    write_hair_file(folder.file("a.hair"), hair);
    write_bytes(folder.file("a.obj"), "v 0 0 4\nv 1 0 4\nv 0 1 4\nf 1 2 3\n");
    write_bytes(folder.file("a.json"), R"({"hair": [{"file": "a.hair"}], "meshes": [{"file": "a.obj"}]})");

    const CommandResult of_hair = run_tress({"info", folder.file("a.hair"), "--json"});
    CHECK(of_hair.exit_code == 0);
    for (const char* part : {"\"strands\": 1", "\"points\": 3", "\"segments\": 2", "\"triangles\": 0"})
        CHECK(contains(of_hair.output, part));
    const CommandResult of_mesh = run_tress({"info", folder.file("a.obj"), "--json"});
    CHECK(of_mesh.exit_code == 0);
    CHECK(contains(of_mesh.output, "\"triangles\": 1"));
    const CommandResult of_scene = run_tress({"info", folder.file("a.json")});
    CAPTURE(of_scene.output);
    CHECK(of_scene.exit_code == 0);
    for (const char* part :
         {"segments          2\n", "triangles         1\n", "[[0.0,0.0,0.0],[1.0,2.0,4.0]]", "[0.125,0.125]"})
        CHECK(contains(of_scene.output, part));
}

TEST_CASE("info ends with 2 and one line for a bad file") {
    const Folder folder;
    for (const std::string& file :
         {folder.file("none.hair"), folder.path(), write_bytes(folder.file("a.exr"), "text")}) {
        const CommandResult run = run_tress({"info", file});
        CAPTURE(run.error);
        CHECK(run.exit_code == 2);
        CHECK(run.error.find('\n') == run.error.size() - 1);
    }
}
