// SPDX-License-Identifier: MIT
// A scene before it is assembled, so that it can be moved and scaled as a whole, in double.
#pragma once

#include "core/scene.h"

namespace tress::test {

struct SceneParts {
    std::vector<PlacedHair> hair;
    std::vector<PlacedMesh> meshes;
    std::vector<Light> lights;
    Camera camera;
};

inline Scene assembled(const SceneParts& parts) {
    return assemble(parts.hair, parts.meshes, parts.lights, parts.camera);
}

/// A point goes to scale * point + shift; what comes from a light onto a surface stays what it was.
struct Move {
    double scale = 1;
    DVec3 shift{0};

    DVec3 point(const DVec3& p) const { return scale * p + shift; }
    void operator()(Placement& placement) const {
        for (double& v : placement.m) v *= scale;
        for (int axis = 0; axis < 3; ++axis) placement.m[size_t(4 * axis + 3)] += shift[axis];
    }
    void operator()(Camera& camera) const {
        camera.from = point(camera.from);
        camera.to = point(camera.to);
    }
    void operator()(PointLight& light) const {
        light.position = point(light.position);
        light.intensity *= float(scale * scale);
    }
    void operator()(SpotLight& light) const {
        light.position = point(light.position);
        light.to = point(light.to);
        light.intensity *= float(scale * scale);
    }
    void operator()(DistantLight&) const {}
    void operator()(QuadLight& light) const {
        light.corner = point(light.corner);
        for (DVec3& edge : light.edge) edge *= scale;
    }
    void operator()(EnvironmentLight&) const {}
};

inline SceneParts moved(SceneParts parts, const Move& move) {
    for (PlacedHair& hair : parts.hair) move(hair.placement);
    for (PlacedMesh& mesh : parts.meshes) move(mesh.placement);
    for (Light& light : parts.lights) std::visit(move, light);
    move(parts.camera);
    return parts;
}

}  // namespace tress::test
