// SPDX-License-Identifier: MIT
// The albedo of the TT lobe as a sum over paths through the fiber, so that many absorptions cost one set of paths.
#pragma once

#include <vector>

#include "core/fiber.h"

namespace tress {

/// albedo(sigma_a) = sum of weight exp(-sigma_a length), averaged over h.
struct ForwardPaths {
    std::vector<double> weight, length;
};
ForwardPaths forward_paths(const Fiber& fiber, double sin_theta);
double albedo(const ForwardPaths& paths, double sigma_a);

}  // namespace tress
