// SPDX-License-Identifier: MIT
#include "core/camera.h"

#include <glm/trigonometric.hpp>

namespace tress {

CameraFrame camera_frame(const Camera& camera) {
    const DVec3 forward = normalize(camera.to - camera.from);
    DVec3 right = cross(forward, camera.up);
    if (dot(right, right) <= 1e-20 * dot(camera.up, camera.up))  // looking along up: any right will do
        right = cross(forward, std::abs(forward.x) < 0.5 ? DVec3(1, 0, 0) : DVec3(0, 0, 1));
    right = normalize(right);
    const DVec3 up = cross(right, forward);
    const double half = std::tan(0.5 * glm::radians(camera.fov));
    const double shorter = std::min(camera.width, camera.height);
    return {right * (half * camera.width / shorter), up * (half * camera.height / shorter), forward};
}

Vec3 camera_direction(const CameraFrame& frame, const Camera& camera, double x, double y) {
    const double u = 2 * x / camera.width - 1, v = 1 - 2 * y / camera.height;
    return Vec3(normalize(frame.forward + u * frame.right + v * frame.up));
}

}  // namespace tress
