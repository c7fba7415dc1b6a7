// SPDX-License-Identifier: MIT
#include "core/hair_measure.h"

#include <algorithm>
#include <thread>

#include "core/camera.h"

namespace tress {
namespace {

/// Of a line through a convex body to that of a body of equal mean shadow: a seen point lies near the rim, and its lamp
/// anywhere, so half the line lies between.
constexpr double kShareOfLine = 0.5;

/// Fibers that a line through the hair crosses, on average: a cylinder of any direction shows pi / 4 of its ribbon, and
/// the hair is taken for an ellipsoid.
double crossings_of_line(const HairMeasure& hair) {
    const DVec3 e(hair.bounds.extent());
    const double shadow = kQuarterPi * (e.x * e.y + e.y * e.z + e.z * e.x) / 3;
    return shadow > 0 ? kQuarterPi * hair.area / shadow : 0;
}

/// After how many fibers a ray counts as blocked.
double crossings_to_cutoff(const Scene& scene, float cutoff) {
    if (scene.fibers.empty() || !(cutoff > 0)) return 1e9;
    const Fiber& fiber = scene.fibers.front();
    const double a = double(max_component(forward_albedo(fiber, fiber.parameters.sigma_a, 0)));
    return a < 1 ? std::log(double(cutoff)) / std::log(std::max(a, 1e-9)) : 1e9;
}

}  // namespace

HairMeasure measure_hair(const SegmentView& hair) {
    HairMeasure m;
    m.bounds = bounds(hair);
    for (size_t i = 0; i < hair.size(); ++i) {
        const double length = double(glm::length(hair.end(i) - hair.start(i)));
        m.length += length;
        m.area += length * double(hair.start_radius(i) + hair.end_radius(i));
    }
    return m;
}

double share_of_picture(const Camera& camera, const Bounds& box) {
    const CameraFrame frame = camera_frame(camera);
    glm::dvec2 low(1), high(-1);
    for (int corner = 0; corner < 8; ++corner) {
        const DVec3 at(corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y,
                       corner & 4 ? box.hi.z : box.lo.z);
        const DVec3 from_eye = at - camera.from;
        const double depth = dot(from_eye, frame.forward) / dot(frame.forward, frame.forward);
        if (!(depth > 0)) return 1;
        const glm::dvec2 on_picture(dot(from_eye, frame.right) / dot(frame.right, frame.right) / depth,
                                    dot(from_eye, frame.up) / dot(frame.up, frame.up) / depth);
        low = min(low, on_picture);
        high = max(high, on_picture);
    }
    low = max(low, glm::dvec2(-1));
    high = min(high, glm::dvec2(1));
    const glm::dvec2 size = max(high - low, glm::dvec2(0));
    return 0.25 * size.x * size.y * kQuarterPi;  // hair is rounder than its box
}

double crossings_of_ray(const Scene& scene, const Options& options, const HairMeasure& hair) {
    return std::min(kShareOfLine * crossings_of_line(hair), crossings_to_cutoff(scene, options.cutoff));
}

double samples_in_time(const Options& options, double seconds) {
    if (!(options.time > 0) || !(seconds > 0)) return options.spp;
    const unsigned cores = options.threads > 0 ? unsigned(options.threads) : std::thread::hardware_concurrency();
    return std::min(double(options.spp), options.time * std::max(cores, 1u) / seconds);
}

}  // namespace tress
