// SPDX-License-Identifier: MIT
// From what a scene file says to a scene ready to render: reads the files, grows hair, makes shapes and fibers.
#pragma once

#include <cstdint>

#include "core/scene.h"
#include "core/scene_description.h"

namespace tress {

struct LoadReport {
    uint64_t strands = 0, points = 0;  // of all hair, children included
    uint64_t dropped_strands = 0;      // of files: fewer than two points. Dropped segments: Scene::segments
};

struct LoadedScene {
    Scene scene;
    LoadReport report;
};

/// Radii: the description's, else the file's or groom's, else kDefaultRadius, times radius_scale. The first and third
/// are lengths after placement, the second is placed with its hair. Colours of a file (clamped to [0, 1]) hold where
/// the description names no absorption; a point whose colour is not finite is treated as one that is not finite itself.
/// Grooms and children are the same for every seed of the options: a seed is for noise, not for hair.
LoadedScene load_scene(const SceneDescription& description);

}  // namespace tress
