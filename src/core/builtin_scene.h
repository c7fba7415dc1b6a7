// SPDX-License-Identifier: MIT
// The scene that is rendered where none is named: a head with wavy hair in a room with coloured walls. In cm.
#pragma once

#include "core/scene_description.h"

namespace tress {

/// Over one million hair segments, the bust of head.h, a room open towards the camera, a key lamp and a weak fill
/// before the head, two lamps behind it that shine through the hair, and a dim sky.
SceneDescription builtin_scene();

}  // namespace tress
