// SPDX-License-Identifier: MIT
#include "core/builtin_scene.h"

namespace tress {
namespace {

constexpr uint64_t kSegments = 1'200'000;
constexpr double kTurn = 32;  // degrees about +y: three quarters of the face
constexpr Rgb kSkin(0.5f, 0.33f, 0.25f);
constexpr Rgb kRed(0.62f, 0.16f, 0.10f), kTeal(0.10f, 0.36f, 0.42f), kNeutral(0.34f, 0.33f, 0.32f);

// The room: wide enough for the shoulders, narrow enough that the walls are in the picture.
constexpr double kHalfWidth = 26, kFloor = -30.05, kCeiling = 34, kBack = -52, kFront = 45;

Placement turned(double degrees) {
    const double angle = glm::radians(degrees), c = std::cos(angle), s = std::sin(angle);
    return {{c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0}};
}

HairDescription hair() {
    HairDescription hair;
    hair.groom = "wavy";
    hair.segments = kSegments;
    hair.placement = turned(kTurn);
    hair.fiber.absorption = Melanin{0.25f, 0.5f};  // auburn
    hair.fiber.parameters.beta_m = 0.2f;
    return hair;
}

MeshDescription wall(const DVec3& a, const DVec3& b, const DVec3& c, const DVec3& d, const Rgb& albedo) {
    return {QuadShape{{a, b, c, d}}, {}, albedo};
}

/// Five sides of a box, seen from within counter-clockwise; open towards +z.
std::vector<MeshDescription> room() {
    const DVec3 left_low_front(-kHalfWidth, kFloor, kFront), left_low_back(-kHalfWidth, kFloor, kBack);
    const DVec3 left_high_front(-kHalfWidth, kCeiling, kFront), left_high_back(-kHalfWidth, kCeiling, kBack);
    const DVec3 across(2 * kHalfWidth, 0, 0);
    return {
        wall(left_low_front, left_low_back, left_high_back, left_high_front, kRed),
        wall(left_low_back + across, left_low_front + across, left_high_front + across, left_high_back + across, kTeal),
        wall(left_low_back, left_low_back + across, left_high_back + across, left_high_back, kNeutral),
        wall(left_low_front, left_low_front + across, left_low_back + across, left_low_back, kNeutral),
        wall(left_high_back, left_high_back + across, left_high_front + across, left_high_front, kNeutral),
    };
}

/// A level-edged lamp that faces `target`.
QuadLight lamp(const DVec3& center, const DVec3& target, double width, double height, const Rgb& radiance) {
    const DVec3 facing = normalize(target - center);
    const DVec3 level = normalize(cross(DVec3(0, 1, 0), facing));
    const DVec3 across = width * level, up = height * cross(facing, level);
    return {center - 0.5 * (across + up), {across, up}, radiance};
}

/// A warm key from the left, a weak cool fill from the right, two rims from behind that shine through the hair, and a
/// little sky.
std::vector<Light> lights() {
    const DVec3 head(0, 0, 0);
    return {
        lamp({-24, 24, 46}, head, 26, 20, Rgb(46, 42, 37)),
        lamp({24, 8, 44}, head, 18, 18, Rgb(6.3f, 7, 8)),
        lamp({-23, 22, -36}, head, 10, 22, Rgb(26, 25, 23)),
        lamp({23, 22, -36}, head, 10, 22, Rgb(21, 23, 26)),
        EnvironmentLight{.file = {}, .image = {}, .radiance = Rgb(0.24f, 0.25f, 0.28f), .rotation = 0},
    };
}

Camera camera() {
    Camera camera;
    camera.from = {0, 3, 80};
    camera.to = {0, -3, 0};
    camera.fov = 27;
    camera.width = camera.height = 640;
    return camera;
}

}  // namespace

SceneDescription builtin_scene() {
    SceneDescription scene;
    scene.path = "built-in scene";
    scene.camera = camera();
    scene.hair = {hair()};
    scene.meshes = room();
    scene.meshes.push_back({HeadShape{}, turned(kTurn), kSkin});
    scene.lights = lights();
    return scene;
}

}  // namespace tress
