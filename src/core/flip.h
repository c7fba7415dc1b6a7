// SPDX-License-Identifier: MIT
// FLIP: how different two pictures look to someone who flips between them. LDR-FLIP: Andersson et al. 2020, "FLIP: A
// Difference Evaluator for Alternating Images"; HDR-FLIP: Andersson et al. 2021, "Visualizing and Communicating Errors
// in Rendered Images". 0: no difference seen, 1: the largest. The same result whatever the number of threads.
#pragma once

#include <vector>

#include "core/image.h"

namespace tress {

/// A 0.7 m wide display of 3840 pixels seen from 0.7 m, the papers' default.
inline constexpr double kFlipPixelsPerDegree = 67;

struct FlipResult {
    double mean = 0;
    std::vector<float> error;  // one a pixel, row by row, in [0, 1]
};

/// Of display-linear pictures (not sRGB encoded); values are clamped to [0, 1]. Symmetric in its two pictures.
/// Throws InputError where a value is not finite or the sizes differ.
FlipResult ldr_flip(const Image& reference, const Image& test, double pixels_per_degree = kFlipPixelsPerDegree);

/// Exposures, in stops, at which HDR-FLIP looks: `count` of them, evenly from `start` to `stop`.
struct FlipExposures {
    double start = 0, stop = 0;
    int count = 0;

    double at(int i) const { return count < 2 ? start : start + (stop - start) * i / (count - 1); }
};
FlipExposures flip_exposures(const Image& reference);

struct HdrFlipResult {
    FlipResult flip;  // a pixel's error is its largest over all exposures
    FlipExposures exposures;
};

/// Of linear pictures of any range: tone-mapped at the reference's exposures (so not symmetric). Negative values count
/// as 0. Throws as ldr_flip does.
HdrFlipResult hdr_flip(const Image& reference, const Image& test, double pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace tress
