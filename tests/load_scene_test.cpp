// SPDX-License-Identifier: MIT
#include "io/load_scene.h"

#include <limits>

#include "io/hair_file.h"
#include "io/scene_file.h"
#include "tests/io_support.h"

using namespace tress;
using namespace tress::test;

namespace {

/// A file of two strands of three points, 1 long each.
HairFile small_hair() {
    HairFile hair;
    hair.strands.first = {0, 3, 6};
    for (int strand = 0; strand < 2; ++strand)
        for (int p = 0; p < 3; ++p) hair.strands.add_point({float(strand), float(p), 0});
    return hair;
}

SceneDescription scene_with(const std::string& file) {
    SceneDescription scene;
    scene.hair.emplace_back();
    scene.hair[0].file = file;
    return scene;
}

Placement scaled_by(double factor) {
    Placement placement;
    for (double& m : placement.m) m *= factor;
    return placement;
}

}  // namespace

TEST_CASE("radii: the description's before the file's before the default, and only the file's grow with placement") {
    const Folder folder;
    const std::string bare = folder.file("bare.hair"), thick = folder.file("thick.hair"),
                      each = folder.file("each.hair");
    HairFile hair = small_hair();
    write_hair_file(bare, hair);
    hair.strands.constant_radius = 0.25f;
    write_hair_file(thick, hair);
    hair.strands.radius = {0.1f, 0.2f, 0.3f, 0.1f, 0.2f, 0.3f};
    write_hair_file(each, hair);

    const auto radius = [](const SceneDescription& s, size_t point) {
        return load_scene(s).scene.hair.radius_at(point);
    };
    SceneDescription scene = scene_with(bare);
    scene.hair[0].placement = scaled_by(2);
    // Scaled down and up again: two roundings.
    CHECK(radius(scene, 0) == doctest::Approx(kDefaultRadius).epsilon(2e-7));
    scene.hair[0].radius_scale = 3;
    CHECK(radius(scene, 0) == doctest::Approx(3 * kDefaultRadius).epsilon(4e-7));
    scene.hair[0].radius_scale = 1;
    scene.hair[0].file = thick;
    CHECK(radius(scene, 0) == 0.5f);
    scene.hair[0].file = each;
    CHECK(radius(scene, 2) == doctest::Approx(0.6f).epsilon(2e-7));
    scene.hair[0].radius = 0.125f;
    CHECK(radius(scene, 2) == 0.125f);
}

TEST_CASE("colours of a file hold only where the description names no absorption") {
    const Folder folder;
    HairFile hair = small_hair();
    hair.strands.constant_radius = 0.01f;
    hair.strands.color.assign(6, Rgb(0.5f, 0.25f, 2.0f));
    hair.strands.color[4].x = std::numeric_limits<float>::quiet_NaN();
    write_hair_file(folder.file("a.hair"), hair);
    SceneDescription scene = scene_with(folder.file("a.hair"));
    const LoadedScene colored = load_scene(scene);
    REQUIRE(colored.scene.sigma_a.size() == 6);
    CHECK(colored.scene.sigma_a[0].z == 0);  // clamped to 1: nothing absorbed
    CHECK(colored.scene.segments.point == std::vector<uint32_t>{0, 1});
    CHECK(colored.scene.segments.dropped == 2);
    scene.hair[0].fiber.absorption = SigmaA{Rgb(0.5f)};
    const LoadedScene plain = load_scene(scene);
    CHECK(plain.scene.sigma_a.empty());
    CHECK(plain.scene.fibers[0].parameters.sigma_a == Rgb(0.5f));
    CHECK(plain.scene.segments.point.size() == 4);
}

TEST_CASE("a hair object without absorption or colours is brown") {
    const Folder folder;
    write_hair_file(folder.file("a.hair"), small_hair());
    const LoadedScene loaded = load_scene(scene_with(folder.file("a.hair")));
    CHECK(loaded.scene.fibers[0].parameters.sigma_a == sigma_a_from_melanin(1.3f, 0));
    CHECK(loaded.report.strands == 2);
    CHECK(loaded.report.points == 6);
}

TEST_CASE("grooms and children do not depend on the seed of the options") {
    SceneDescription scene;
    scene.hair.emplace_back();
    scene.hair[0].groom = "short";
    scene.hair[0].segments = 2000;
    scene.hair[0].children = {3, 0.2};
    const LoadedScene a = load_scene(scene);
    scene.options.seed = 7;
    const LoadedScene b = load_scene(scene);
    CHECK(a.scene.hair.x == b.scene.hair.x);
    CHECK(a.report.strands % 3 == 0);
    CHECK(a.report.strands == a.scene.hair.strands());
}

TEST_CASE("quads and spheres far from the origin keep their size to the last digit") {
    SceneDescription scene;
    const DVec3 far(1e7, -2e7, 3e7);
    MeshDescription quad, sphere;
    quad.shape = QuadShape{{far, far + DVec3(0.01, 0, 0), far + DVec3(0.01, 0.01, 0), far + DVec3(0, 0.01, 0)}};
    sphere.shape = SphereShape{far, 0.01};
    scene.meshes = {quad, sphere};
    const Scene loaded = load_scene(scene).scene;
    CHECK(loaded.mesh.vertex(1).x - loaded.mesh.vertex(0).x == doctest::Approx(0.01).epsilon(1e-6));
    // North pole over south pole: a diameter. Coordinates of 3e7 in double have an ulp of 4e-9.
    CHECK(loaded.mesh.vertex(4).y - loaded.mesh.vertex(5).y == doctest::Approx(0.02).epsilon(1e-6));
    CHECK(loaded.albedo.size() == 2);
}

TEST_CASE("what is wrong in an object is said with its place in the scene file") {
    const Folder folder;
    const std::string path = folder.file("scene.json");
    const auto message = [&](const std::string& hair) {
        write_bytes(path, R"({"hair": [{"groom": "short", "segments": 100}, )" + hair + "]}");
        return message_of([&] { load_scene(read_scene_file(path)); });
    };
    for (const auto& [hair, part] : {std::pair(R"({"groom": "wavi"})", "nearest known: 'wavy'"),
                                     std::pair(R"({"groom": "wavy", "fiber": {"beta_m": 2}})", "beta_m"),
                                     std::pair(R"({"groom": "wavy", "fiber": {"eta": 0.5}})", "eta")}) {
        const std::string text = message(hair);
        CAPTURE(text);
        CHECK(is_one_line(text));
        CHECK(contains(text, "scene.json: hair[1]: "));
        CHECK(contains(text, part));
    }
    CHECK(contains(message(R"({"file": "none.hair"})"), "none.hair: no such file"));
}

TEST_CASE("real scenes of hair, head and sky load") {
    const auto hair = real_file("hair/digital-salon/harolongo.data");
    if (!hair) return;
    const Folder folder;
    const std::string path = write_bytes(folder.file("scene.json"), R"({
        "hair": [{"file": "${TRESS_DATA}/hair/digital-salon/harolongo.data"}],
        "meshes": [{"file": "${TRESS_DATA}/hair/digital-salon/head.obj"}],
        "lights": [{"type": "environment", "file": "${TRESS_DATA}/env/studio.exr"}]})");
    const LoadedScene loaded = load_scene(read_scene_file(path));
    CHECK(loaded.scene.segments.point.size() + loaded.scene.segments.dropped == 158100);
    CHECK(loaded.scene.mesh.triangles() == 21510);
    CHECK(std::get<EnvironmentLight>(loaded.scene.lights[0]).image.width == 512);
}
