// SPDX-License-Identifier: MIT
#include "core/hair_measure.h"

#include <algorithm>
#include <bitset>
#include <thread>

#include "core/camera.h"
#include "core/rng.h"

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

double share_of_picture(const Camera& camera, const SegmentView& hair) {
    constexpr int kParts = 64;
    constexpr size_t kMostAsked = 100'000;
    const CameraFrame frame = camera_frame(camera);
    std::bitset<kParts * kParts> has_hair;
    const size_t stride = hair.size() / kMostAsked + 1;
    for (size_t block = 0; block < hair.size(); block += stride) {
        // Any of the block: strands are of even length, and one place of each would say little.
        const size_t i = std::min(block + size_t(hash(0x7368, block) % stride), hair.size() - 1);
        const DVec3 from_eye = 0.5 * (DVec3(hair.start(i)) + DVec3(hair.end(i))) - camera.from;
        const double depth = dot(from_eye, frame.forward) / dot(frame.forward, frame.forward);
        if (!(depth > 0)) continue;
        const double right = dot(from_eye, frame.right) / dot(frame.right, frame.right) / depth;
        const double up = dot(from_eye, frame.up) / dot(frame.up, frame.up) / depth;
        if (!(std::abs(right) < 1 && std::abs(up) < 1)) continue;
        const auto part = [](double x) { return std::min(size_t(0.5 * (x + 1) * kParts), size_t(kParts - 1)); };
        has_hair.set(part(up) * kParts + part(right));
    }
    return double(has_hair.count()) / double(has_hair.size());
}

double area_of_picture(const Camera& camera, const Bounds& box) {
    const CameraFrame frame = camera_frame(camera);
    const double depth = dot(DVec3(box.center()) - camera.from, frame.forward) / dot(frame.forward, frame.forward);
    return depth > 0 ? 4 * length(frame.right) * length(frame.up) * square(depth) : double(kInfinity);
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
