// SPDX-License-Identifier: MIT
// Scenes small enough to know their answers.
#pragma once

#include "core/scene.h"
#include "gather/render.h"

namespace tress::test {

/// Straight fibers along +y through the given x, z, from y = -half to half.
inline PlacedHair upright_fibers(const std::vector<Vec2>& xz, float half, float radius, const Fiber& fiber) {
    PlacedHair hair;
    hair.strands.constant_radius = radius;
    hair.strands.first = {0};
    for (const Vec2& at : xz) {
        hair.strands.add_point({at.x, -half, at.y});
        hair.strands.add_point({at.x, half, at.y});
        hair.strands.first.push_back(uint32_t(hair.strands.points()));
    }
    hair.fiber = fiber;
    return hair;
}

/// A square in the plane z = 0, facing +z.
inline PlacedMesh square(float half, const Rgb& albedo) {
    PlacedMesh mesh;
    for (const Vec2& corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)})
        mesh.mesh.add_vertex(Vec3(half * corner, 0));
    mesh.mesh.corner = {0, 1, 2, 0, 2, 3};
    mesh.albedo = albedo;
    return mesh;
}

inline Fiber white_fiber() { return make_fiber({}); }

/// Looks from (0, 0, distance) at the origin.
inline Camera camera_on_z(double distance, double fov, int size) {
    Camera camera;
    camera.from = {0, 0, distance};
    camera.to = {0, 0, 0};
    camera.fov = fov;
    camera.width = camera.height = size;
    return camera;
}

/// Defaults with as many photons as small scenes need.
inline Options small_options() {
    Options options;
    options.photons.count = 5000;
    return options;
}

struct Rendered {
    Plan plan;
    PreparedScene prepared;
    RenderState state;
    LayeredImage picture;

    const Layer* layer(const std::string& name) const {
        for (const Layer& l : picture.layers)
            if (l.name == name) return &l;
        return nullptr;
    }
};

inline Rendered render(const Scene& scene, const Options& options) {
    Rendered r;
    r.plan = make_plan(scene, options);
    r.prepared = prepare(scene, r.plan, options);
    r.state = make_state(scene, r.plan);
    advance(r.state, scene, r.prepared, r.plan, options, options.spp);
    r.picture = develop(r.state.film);
    return r;
}

}  // namespace tress::test
