// SPDX-License-Identifier: MIT
#include "gather/crossing_light.h"

#include "gather/connection.h"
#include "gather/reservoir.h"
#include "gather/streams.h"

namespace tress {
namespace {

constexpr size_t kBatch = 1024;  // gather rays at a time: their crossings are some ten times as many

constexpr uint32_t kSweepDimension = 0, kFirstCrossingDimension = kSobolGroup;

/// Each crossing that counts has a group for the lamp to keep, and one for each lamp.
uint32_t dimensions_a_crossing(size_t lamps) { return kSobolGroup * uint32_t(1 + lamps); }

}  // namespace

/// Fills counted_ with crossings first .. first + before.size() - 1: all, or `most` drawn by the luminance of `before`
/// in one even sweep, which u in [0, 1) sets off. One that is drawn more than once stands there once.
void CrossingLight::count_crossings(std::span<const Rgb> before, uint64_t first, int most, float u) {
    counted_.clear();
    if (most == 0) {
        for (uint64_t k = 0; k < before.size(); ++k) counted_.push_back({first + k, 1});
        return;
    }
    double sum = 0;
    for (const Rgb& b : before) sum += double(luminance(b));
    const double step = sum / most;
    double below = 0;
    int drawn = 0;
    for (uint64_t k = 0; k < before.size(); ++k) {
        const double own = double(luminance(before[k]));
        below += own;
        const int drawn_before = drawn;
        while (drawn < most && (drawn + double(u)) * step < below) ++drawn;
        if (drawn > drawn_before) counted_.push_back({first + k, (drawn - drawn_before) * step / own});
    }
}

/// `throughput`: what of the light that leaves `point` arrives at the eye.
void CrossingLight::add_shadow_ray(const Scene& scene, const ShadingPoint& point, std::span<const uint32_t> lamps,
                                   const Sampler& sampler, uint32_t dimension, const Rgb& throughput, uint32_t row) {
    Connection kept;
    uint32_t kept_lamp = 0;
    Rgb color(0);  // of the light of the lamp kept, at luminance 1
    Reservoir reservoir(sampler.get(dimension));
    for (const uint32_t lamp : lamps) {
        dimension += kSobolGroup;
        const Connection to = connect_lamp(scene, point, scene.lights[lamp], sampler.get2(dimension));
        const Rgb brought = bounded(throughput * to.radiance);
        const float weight = luminance(brought);
        if (!(weight > 0) || !reservoir.offer(weight)) continue;
        kept = to;
        kept_lamp = lamp;
        color = brought / weight;
    }
    if (!(reservoir.sum() > 0)) return;
    shadow_rays_.add(point.position, kept.direction, kept.distance, point.excluded, kept_lamp, kept.place,
                     point.segment);
    row_.push_back(row);
    unshadowed_.push_back(bounded(color * reservoir.sum()));
}

/// Of gather ray `ray`, which crosses fibers begin .. end - 1 of those found for the batch.
void CrossingLight::add_shadow_rays(const Scene& scene, const PreparedScene& prepared, const Options& options,
                                    std::span<const uint32_t> lamps, const GatherRays& gather, size_t ray,
                                    uint64_t begin, uint64_t end) {
    const Crossings& found = flights_.crossings;
    const Sampler sampler = stream_of(gather.samplers[ray], Stream::crossings);
    count_crossings(std::span(flights_.before).subspan(begin, end - begin), begin, options.gather.crossings,
                    sampler.get(kSweepDimension));
    uint32_t dimension = kFirstCrossingDimension;
    for (const Counted& c : counted_) {
        const uint64_t k = c.crossing;
        ShadingPoint point =
            fiber_point(scene, prepared, gather.rays.direction(ray), {found.t[k], found.id[k], found.u[k], found.h[k]});
        point.lobes = FiberLobes::reflected;
        const Rgb throughput = gather.weight[ray] * flights_.before[k] * float(c.share);
        add_shadow_ray(scene, point, lamps, sampler, dimension, throughput, gather.point[ray]);
        dimension += dimensions_a_crossing(lamps.size());
    }
}

void CrossingLight::operator()(const Scene& scene, const PreparedScene& prepared, const Options& options,
                               std::span<const uint32_t> lamps, const LampMaps* maps, const GatherRays& gather,
                               std::span<Rgb> radiance) {
    const RayBatch rays = gather.rays.for_hair();
    for (size_t first = 0; first < gather.size(); first += kBatch) {
        const size_t count = std::min(kBatch, gather.size() - first);
        cutoff_.assign(count, options.cutoff);
        flights(prepared.hair, rays.part(first, count), prepared.attenuation, cutoff_, flights_, options.isa);

        shadow_rays_.clear();
        row_.clear();
        unshadowed_.clear();
        const std::vector<uint64_t>& crossing = flights_.crossings.first;
        for (size_t i = 0; i < count; ++i)
            if (crossing[i] < crossing[i + 1])
                add_shadow_rays(scene, prepared, options, lamps, gather, first + i, crossing[i], crossing[i + 1]);
        visibility_.resize(shadow_rays_.size());
        query_(scene, prepared, maps, options.maps.near_crossings, options, shadow_rays_, visibility_);
        for (size_t i = 0; i < shadow_rays_.size(); ++i) radiance[row_[i]] += unshadowed_[i] * visibility_[i];
    }
}

}  // namespace tress
