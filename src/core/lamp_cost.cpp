// SPDX-License-Identifier: MIT
#include "core/lamp_cost.h"

#include <thread>

#include "core/camera.h"
#include "core/segments.h"

namespace tress {
namespace {

// Measured on one core of an Intel Xeon (Sapphire Rapids, AVX-512); docs/light.md says how. Other machines scale all of
// them alike.
constexpr double kShadeSeconds = 0.45e-6;     // a way to a lamp, without what is between
constexpr double kRaySeconds = 0.67e-6;       // a shadow ray from hair, and
constexpr double kCrossingSeconds = 0.31e-6;  // each fiber that it crosses
constexpr double kAskSeconds = 0.78e-6;       // a short ray and a look-up
constexpr double kSegmentSeconds = 0.72e-6;   // a segment put on a map, and
constexpr double kFragmentSeconds = 0.27e-6;  // each texel that it touches

/// Of a line through a convex body to that of a body of equal mean shadow: a seen point lies near the rim, and its lamp
/// anywhere, so half the line lies between.
constexpr double kShareOfLine = 0.5;

constexpr double kQuarterPi = 0.78539816339744830962;

struct HairMeasure {
    Bounds bounds;
    double length = 0, area = 0;  // of all axes; of all ribbons: length times width
};

HairMeasure measure(const SegmentView& hair) {
    HairMeasure m;
    m.bounds = bounds(hair);
    for (size_t i = 0; i < hair.size(); ++i) {
        const double length = double(glm::length(hair.end(i) - hair.start(i)));
        m.length += length;
        m.area += length * double(hair.start_radius(i) + hair.end_radius(i));
    }
    return m;
}

/// Share of the picture that a box covers, by the rectangle about its corners; 1 where the eye is in it or next to it.
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

/// Seconds that one sample of every pixel takes by rays and by maps.
struct SampleCost {
    double rays = 0, maps = 0;
};

SampleCost cost_of_sample(const Scene& scene, const Options& options, const HairMeasure& hair, size_t lamps) {
    const double pixels = double(scene.camera.width) * scene.camera.height;
    const double share = share_of_picture(scene.camera, hair.bounds), others = scene.mesh.triangles() ? 1 - share : 0;
    const double crossings =
        std::min(kShareOfLine * crossings_of_line(hair), crossings_to_cutoff(scene, options.cutoff));
    const double either = (share + others) * kShadeSeconds;
    const double ways = pixels * double(lamps);
    return {ways * (either + share * (kRaySeconds + crossings * kCrossingSeconds)),
            ways * (either + share * kAskSeconds)};
}

/// Samples a pixel; with a limit of time, those that rays take in it.
double samples(const Options& options, double seconds_each) {
    if (!(options.time > 0) || !(seconds_each > 0)) return options.spp;
    const unsigned cores = options.threads > 0 ? unsigned(options.threads) : std::thread::hardware_concurrency();
    return std::min(double(options.spp), options.time * std::max(cores, 1u) / seconds_each);
}

}  // namespace

size_t view_count(const Light& light, int grid) {
    return std::holds_alternative<QuadLight>(light) ? size_t(grid) * size_t(grid) : 1;
}

LampCost estimate_lamp_cost(const Scene& scene, const Options& options, std::span<const uint32_t> lamps) {
    const SegmentView segments = view(scene.hair, scene.segments);
    const HairMeasure hair = measure(segments);
    const SampleCost sample = cost_of_sample(scene, options, hair, lamps.size());
    const double spp = samples(options, sample.rays);
    const double texel = double(max_component(hair.bounds.extent())) / options.maps.resolution;
    const double fragments = texel > 0 ? kQuarterPi * hair.length / texel : 0;
    LampCost cost{spp * sample.rays, spp * sample.maps, 0};
    for (const uint32_t lamp : lamps)
        cost.build += double(view_count(scene.lights[lamp], options.maps.grid)) *
                      (double(segments.size()) * kSegmentSeconds + fragments * kFragmentSeconds);
    return cost;
}

}  // namespace tress
