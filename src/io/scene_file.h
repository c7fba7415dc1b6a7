// SPDX-License-Identifier: MIT
// Reads a scene file (JSON; its keys are in docs/scene.md). Names of files in it are relative to it, and ${NAME} in
// them stands for what the environment says; the description holds them ready to open.
#pragma once

#include <string>

#include "core/scene_description.h"

namespace tress {

/// Throws InputError that names the file, the place in it, what was found and what was expected.
SceneDescription read_scene_file(const std::string& path);

}  // namespace tress
