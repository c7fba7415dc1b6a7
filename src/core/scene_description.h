// SPDX-License-Identifier: MIT
// What a scene file says, word for word: nothing loaded, nothing moved.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/camera.h"
#include "core/fiber.h"
#include "core/light.h"
#include "core/options.h"
#include "core/placement.h"

namespace tress {

/// Extra strands about each guide.
struct Children {
    int count = 0;        // strands in all a guide, the guide included; 0 and 1: no more than the guide
    double spread = 0.3;  // radius of the disc about the guide, scene units
};

struct Melanin {
    float eumelanin = 1.3f, pheomelanin = 0;
};
struct SigmaA {
    Rgb value{0};
};
struct FiberColor {
    Rgb value{1};
};

struct FiberDescription {
    FiberParameters parameters;  // sigma_a is not read: `absorption` says it
    /// Nothing: the colours of the file where it has any, else brown hair (eumelanin 1.3).
    std::variant<std::monostate, Melanin, SigmaA, FiberColor> absorption;
};

struct HairDescription {
    std::string file;             // or
    std::string groom;            // a procedural one
    uint64_t segments = 1000000;  // of the groom
    Placement placement;
    std::optional<float> radius;  // scene units after placement; absent: the file's, else kDefaultRadius
    float radius_scale = 1;
    Children children;
    FiberDescription fiber;
};
inline constexpr float kDefaultRadius = 0.004f;  // cm: a human hair of 80 micrometres

struct QuadShape {
    std::array<DVec3, 4> corner;
};
struct SphereShape {
    DVec3 center{0};
    double radius = 1;
};
/// The bust of head.h, in cm.
struct HeadShape {};

struct MeshDescription {
    std::variant<std::string, QuadShape, SphereShape, HeadShape> shape;  // a file's path, or a shape
    Placement placement;
    Rgb albedo{0.5f};
};

struct SceneDescription {
    std::string path;  // of the scene file, for messages
    Camera camera;
    std::vector<HairDescription> hair;
    std::vector<MeshDescription> meshes;
    std::vector<Light> lights;
    Options options;
};

}  // namespace tress
