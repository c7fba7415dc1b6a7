// SPDX-License-Identifier: MIT
// From a linear picture of any range to display light in [0, 1], for PNGs (which add the sRGB encoding).
//
// The curve is the identity up to mid-grey (0.18), so that dark hair keeps its tones, and bends above it in a shoulder
// a + (1 - a) t / (1 + t^p)^(1/p), t = (x - a) / (1 - a): Reinhard's t / (1 + t) generalised by the power p, with
// slope 1 at mid-grey. Bending every channel alone bleaches highlights and shifts hues; bending the largest and scaling
// the others keeps hue and saturation but never reaches white. The result is the mean of the two.
#pragma once

#include "core/image.h"

namespace tress {

/// Negative channels and those that are not numbers count as 0, infinite ones become white.
Rgb tone_map(const Rgb& linear, float exposure_stops);

Image tone_map(const Image& linear, float exposure_stops);

}  // namespace tress
