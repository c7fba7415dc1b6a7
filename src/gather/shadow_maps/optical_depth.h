// SPDX-License-Identifier: MIT
// Optical depth of a fragment of hair: depths add up along the light, whatever the order.
#pragma once

#include "core/attenuation.h"

namespace tress {

/// -log(1 - opacity), at most kOpaqueDepth so that sums stay finite. By log1p: 1 - 1e-8f is 1.
inline float optical_depth(float opacity) {
    return opacity < 1 ? glm::min(-std::log1p(-opacity), kOpaqueDepth) : kOpaqueDepth;
}

}  // namespace tress
