// SPDX-License-Identifier: MIT
// A fiber as a scene file or the command line describes it.
#pragma once

#include <span>
#include <string>

#include "core/scene_description.h"
#include "io/json_value.h"

namespace tress {

/// What the object says; the rest stays as in `fiber`.
FiberDescription read_fiber(const JsonValue& object, FiberDescription fiber);

/// The same from "key=value" texts; a value of several numbers has commas: "color=0.8,0.5,0.2". `where` names them in
/// errors.
FiberDescription read_fiber(std::span<const std::string> assignments, const std::string& where, FiberDescription fiber);

}  // namespace tress
