// SPDX-License-Identifier: MIT
#include "accel/queries.h"

#include <cassert>

#include "accel/highway_targets.h"
#include "accel/isa_targets.h"
#include "accel/query_kernels.h"
#include "accel/transmission_powers.h"

#define HWY_TARGET_INCLUDE "accel/queries.cpp"
// foreach_target.h compiles what follows it once a target, and must stand first.
// clang-format off
#include "hwy/foreach_target.h"
#include "accel/crossing_queries-inl.h"
#include "accel/segment_queries-inl.h"
#include "accel/triangle_queries-inl.h"
#include "hwy/highway.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

QueryKernels query_kernels() {
    return {nearest_segment, nearest_triangle, occluded_triangle, count_crossings, transmittance, crossings, flights};
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tress {
namespace {

HWY_EXPORT(query_kernels);

QueryKernels kernels_for(Isa isa) { return HWY_DISPATCH_TABLE(query_kernels)[kernel_index(isa)](); }

}  // namespace

void nearest_segment(const KdTree& tree, const RayBatch& rays, const NearestHits& hits, Isa isa) {
    kernels_for(isa).nearest_segment(tree, rays, hits);
}

void nearest_triangle(const KdTree& tree, const RayBatch& rays, const NearestHits& hits, Isa isa) {
    kernels_for(isa).nearest_triangle(tree, rays, hits);
}

void occluded_triangle(const KdTree& tree, const RayBatch& rays, std::span<uint8_t> occluded, Isa isa) {
    kernels_for(isa).occluded_triangle(tree, rays, occluded);
}

void transmittance_constant(const KdTree& tree, const RayBatch& rays, float transmission, float cutoff,
                            std::span<float> transmittance, std::span<uint32_t> crossings, Isa isa) {
    assert(transmission >= 0 && transmission <= 1);
    const uint32_t limit = first_below(double(transmission), double(cutoff));
    kernels_for(isa).count_crossings(tree, rays, limit, crossings);
    TransmissionPowers power{double(transmission)};
    for (size_t i = 0; i < rays.size(); ++i) transmittance[i] = power(crossings[i]);
}

void transmittance(const KdTree& tree, const RayBatch& rays, const Attenuation& attenuation, float cutoff,
                   std::span<Rgb> transmittance, Isa isa) {
    kernels_for(isa).transmittance(tree, rays, attenuation, cutoff, transmittance);
}

Crossings crossings(const KdTree& tree, const RayBatch& rays, Isa isa) {
    Crossings found;
    found.first.reserve(rays.size() + 1);
    found.first.push_back(0);
    kernels_for(isa).crossings(tree, rays, found);
    return found;
}

void flights(const KdTree& tree, const RayBatch& rays, const Attenuation& attenuation, std::span<const float> cutoff,
             Flights& found, Isa isa) {
    assert(cutoff.size() == rays.size());
    Crossings& c = found.crossings;
    for (auto* floats : {&c.t, &c.u, &c.h}) floats->clear();
    for (auto* colors : {&found.before, &found.after}) colors->clear();
    c.id.clear();
    c.first.assign(1, 0);
    kernels_for(isa).flights(tree, rays, attenuation, cutoff, found);
}

}  // namespace tress
#endif
