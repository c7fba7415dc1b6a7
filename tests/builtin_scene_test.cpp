// SPDX-License-Identifier: MIT
#include "core/builtin_scene.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "core/groom.h"
#include "core/head.h"

using namespace tress;

namespace {

DVec3 normal(const QuadShape& quad) {
    return normalize(cross(quad.corner[1] - quad.corner[0], quad.corner[3] - quad.corner[0]));
}

}  // namespace

TEST_CASE("the built-in scene has a groom that there is, of over a million segments, on a head as turned as it") {
    const SceneDescription scene = builtin_scene();
    REQUIRE(scene.hair.size() == 1);
    const auto names = groom_names();
    CHECK(std::find(names.begin(), names.end(), scene.hair[0].groom) != names.end());
    CHECK(scene.hair[0].segments > 1000000);
    int heads = 0;
    for (const MeshDescription& mesh : scene.meshes) {
        if (!std::holds_alternative<HeadShape>(mesh.shape)) continue;
        ++heads;
        CHECK(mesh.placement.m == scene.hair[0].placement.m);
    }
    CHECK(heads == 1);
}

TEST_CASE("walls face into the built-in room, lamps shine on the head, and the camera stands before it") {
    const SceneDescription scene = builtin_scene();
    for (const MeshDescription& mesh : scene.meshes) {
        const auto* quad = std::get_if<QuadShape>(&mesh.shape);
        if (!quad) continue;
        CHECK(dot(normal(*quad), -quad->corner[0]) > 0);
        // The bust lies on the inner side of every wall.
        const Bounds box = head_bounds();
        for (const Vec3& corner : {box.lo, box.hi, Vec3(box.lo.x, box.hi.y, box.lo.z), Vec3(box.hi.x, 0, box.hi.z)}) {
            if (corner.y < -30) continue;  // the room of the box below the bust
            CHECK(dot(normal(*quad), DVec3(corner) - quad->corner[0]) > 0);
        }
    }
    int lamps = 0;
    for (const Light& light : scene.lights) {
        const auto* lamp = std::get_if<QuadLight>(&light);
        if (!lamp) continue;
        ++lamps;
        const DVec3 middle = lamp->corner + 0.5 * (lamp->edge[0] + lamp->edge[1]);
        const DVec3 facing = normalize(cross(lamp->edge[0], lamp->edge[1]));
        CHECK(dot(facing, normalize(-middle)) > 0.9);
    }
    CHECK(lamps == 4);
    CHECK(scene.camera.from.z > 60);
}
