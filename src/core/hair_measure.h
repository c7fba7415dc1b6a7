// SPDX-License-Identifier: MIT
// How much hair there is and how much of the picture it fills: what estimates of cost are made from.
#pragma once

#include "core/options.h"
#include "core/scene.h"
#include "core/segments.h"

namespace tress {

/// pi / 4: the mean sine of random directions to an axis, and the share of a rectangle that its ellipse fills.
inline constexpr double kQuarterPi = 0.78539816339744830962;

struct HairMeasure {
    Bounds bounds;
    double length = 0, area = 0;  // of all axes; of all ribbons: length times width
};

HairMeasure measure_hair(const SegmentView& hair);

/// Share of the picture that has hair, whether something hides it or not: of its parts, 64 by 64, those that the middle
/// of some segment is in.
double share_of_picture(const Camera& camera, const SegmentView& hair);

/// Area that the picture shows, square with the view, where the box's middle is; infinity where that is not ahead.
double area_of_picture(const Camera& camera, const Bounds& box);

/// Fibers that a ray from a seen point crosses, on average, until it is out of the hair or counts as blocked.
double crossings_of_ray(const Scene& scene, const Options& options, const HairMeasure& hair);

/// Samples a pixel; with a limit of time, those that fit in it at `seconds` of one core each.
double samples_in_time(const Options& options, double seconds);

}  // namespace tress
