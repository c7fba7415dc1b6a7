// SPDX-License-Identifier: MIT
// A pinhole camera.
#pragma once

#include "core/math.h"

namespace tress {

struct Camera {
    DVec3 from{0, 20, 60}, to{0, 10, 0}, up{0, 1, 0};
    double fov = 30;  // degrees, across the shorter side of the picture
    int width = 512, height = 512;
};

/// The camera's axes: right, up and forward, and how much a unit of each spans on the picture.
struct CameraFrame {
    DVec3 right, up, forward;  // right and up scaled so that picture coordinates run over [-1, 1]
};
CameraFrame camera_frame(const Camera& camera);

/// Unit direction through the picture point (x, y) in pixels, from the top left corner.
Vec3 camera_direction(const CameraFrame& frame, const Camera& camera, double x, double y);

}  // namespace tress
