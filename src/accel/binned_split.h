// SPDX-License-Identifier: MIT
// The approximate search: faces are counted in equal bins of the cell, all three axes in one pass; the planes between
// bins are the candidates.
#pragma once

#include <span>

#include "accel/cost_model.h"

namespace tress {

/// Parallel for large nodes; counts are whole numbers, so the result does not depend on the threads.
std::optional<Split> binned_split(std::span<const Reference> references, const Bounds& cell,
                                  const AccelOptions& options);

}  // namespace tress
