// SPDX-License-Identifier: MIT
// Which lights can reach a scene at all.
#pragma once

#include <string>

#include "core/bounds.h"
#include "core/light.h"

namespace tress {

/// Why no light of this kind and place can reach the scene; empty: it may.
std::string why_unseen(const Light& light, const Bounds& bounds);

/// "quad", "environment" …
const char* light_name(const Light& light);

}  // namespace tress
