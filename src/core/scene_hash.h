// SPDX-License-Identifier: MIT
// One number for all that a scene ready to render holds: what is kept of a scene's renders is found again by it.
#pragma once

#include <cstdint>

#include "core/scene.h"

namespace tress {

/// Differs, but for chance (2^-64), where anything differs that a picture depends on: hair, meshes, lights, camera.
uint64_t scene_hash(const Scene& scene);

}  // namespace tress
