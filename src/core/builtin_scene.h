// SPDX-License-Identifier: MIT
// The scene that is rendered where none is named: a head with wavy hair in a room with coloured walls. In cm.
#pragma once

#include "core/scene_description.h"

namespace tress {

/// Over one million hair segments, the bust of head.h, four walls and a floor open towards the camera, a lamp below the
/// ceiling, a weaker one behind the head, and a dim sky before the room.
SceneDescription builtin_scene();

}  // namespace tress
