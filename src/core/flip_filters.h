// SPDX-License-Identifier: MIT
// The filters of FLIP (Andersson et al. 2020, sec. 4.1 and 4.2), each as filters along rows and down columns.
#pragma once

#include "core/separable_filter.h"

namespace tress {

/// One channel of the eye's contrast sensitivity: a sum of Gaussians, each the same along rows and down columns
/// (its weight is in the row filter). Together they sum to 1.
struct SensitivityTerm {
    Kernel row, column;
};

/// Filters made for one viewing distance.
struct FlipFilters {
    SensitivityTerm achromatic, red_green, blue_yellow[2];
    Kernel smooth, edge, point;  // along the other axis; first derivative; second derivative of a Gaussian
};
FlipFilters make_flip_filters(double pixels_per_degree);

}  // namespace tress
