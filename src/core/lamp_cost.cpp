// SPDX-License-Identifier: MIT
#include "core/lamp_cost.h"

#include "core/hair_measure.h"
#include "core/measured_seconds.h"

namespace tress {
namespace {

/// Seconds that one sample of every pixel takes by rays and by maps.
struct SampleCost {
    double rays = 0, maps = 0;
};

SampleCost cost_of_sample(const Scene& scene, const Options& options, const SegmentView& segments,
                          const HairMeasure& hair, size_t lamps) {
    const double pixels = double(scene.camera.width) * scene.camera.height;
    const double share = share_of_picture(scene.camera, segments), others = scene.mesh.triangles() ? 1 - share : 0;
    const double crossings = crossings_of_ray(scene, options, hair);
    const double either = (share + others) * kShadeSeconds;
    const double ways = pixels * double(lamps);
    return {ways * (either + share * (kRaySeconds + crossings * kCrossingSeconds)),
            ways * (either + share * kAskSeconds)};
}

}  // namespace

size_t view_count(const Light& light, int grid) {
    return std::holds_alternative<QuadLight>(light) ? size_t(grid) * size_t(grid) : 1;
}

LampCost estimate_lamp_cost(const Scene& scene, const Options& options, std::span<const uint32_t> lamps) {
    const SegmentView segments = view(scene.hair, scene.segments);
    const HairMeasure hair = measure_hair(segments);
    const SampleCost sample = cost_of_sample(scene, options, segments, hair, lamps.size());
    const double spp = samples_in_time(options, sample.rays);
    const double texel = double(max_component(hair.bounds.extent())) / options.maps.resolution;
    const double fragments = texel > 0 ? hair.length * kQuarterPi / texel : 0;
    LampCost cost{spp * sample.rays, spp * sample.maps, 0};
    for (const uint32_t lamp : lamps)
        cost.build += double(view_count(scene.lights[lamp], options.maps.grid)) *
                      (double(segments.size()) * kSegmentSeconds + fragments * kFragmentSeconds);
    return cost;
}

}  // namespace tress
