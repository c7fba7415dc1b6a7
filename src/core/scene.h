// SPDX-License-Identifier: MIT
// A scene ready to render: everything loaded, grown, placed, and moved so that the middle of its hair is the origin.
#pragma once

#include <vector>

#include "core/camera.h"
#include "core/fiber.h"
#include "core/light.h"
#include "core/mesh.h"
#include "core/placement.h"
#include "core/segments.h"
#include "core/strands.h"

namespace tress {

/// Hair with where it goes and what it is made of: the input of assemble().
struct PlacedHair {
    StrandSet strands;  // as its file has it; colours removed where the fiber's own absorption holds
    Placement placement;
    Fiber fiber;
};

struct PlacedMesh {
    TriangleMesh mesh;
    Placement placement;
    Rgb albedo{0.5f};
};

struct Scene {
    DVec3 origin{0};                      // what was subtracted from every coordinate
    StrandSet hair;                       // all hair objects, one after the other
    SegmentList segments;                 // of `hair`
    std::vector<uint32_t> fiber_segment;  // first segment of each fiber, and one past the end
    std::vector<Fiber> fibers;            // one a hair object
    std::vector<Rgb> sigma_a;             // one a point of `hair`, or empty: no strand has a colour of its own
    TriangleMesh mesh;                    // all meshes
    std::vector<Rgb> albedo;              // one a surface of `mesh`
    std::vector<Light> lights;
    Camera camera;
    Bounds bounds;  // of hair, its radii included, and meshes
};

/// Places everything in double, moves the middle of the hair (without hair: of the meshes) to the origin, and rounds to
/// float once. Throws InputError where hair is thinner than 4 ulp of its coordinates, as given or recentred, and where
/// there are more points or vertices than 32 bits count.
Scene assemble(std::vector<PlacedHair> hair, std::vector<PlacedMesh> meshes, std::vector<Light> lights,
               const Camera& camera);

/// Which fiber a segment is made of.
uint32_t fiber_of(const Scene& scene, uint32_t segment);

}  // namespace tress
