// SPDX-License-Identifier: MIT
// Splits that ask no cost, to study what the heuristic is worth: across the longest side of the cell, through its
// middle or through the median of the boxes' centres. Their cost is computed all the same, for automatic termination.
#pragma once

#include <span>
#include <vector>

#include "accel/cost_model.h"

namespace tress {

std::optional<Split> spatial_median_split(std::span<const Reference> references, const Bounds& cell,
                                          const AccelOptions& options);

/// `centers`: work space, kept between calls.
std::optional<Split> object_median_split(std::span<const Reference> references, const Bounds& cell,
                                         const AccelOptions& options, std::vector<float>& centers);

}  // namespace tress
