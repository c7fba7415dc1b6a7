// SPDX-License-Identifier: MIT
#include "accel/queries.h"

#include <cassert>
#include <string>
#include <utility>

#include "accel/query_kernels.h"
#include "accel/transmission_powers.h"
#include "core/error.h"

// All targets, the scalar one too, so that each can be asked for. Without those whose vectors have no size known to
// the compiler, and without SSSE3, which no name stands for.
#define HWY_COMPILE_ALL_ATTAINABLE
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
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

struct NamedTargets {
    Isa isa;
    std::string_view name;
    int64_t targets;  // of Highway; one of them will do
};
constexpr NamedTargets kNamed[] = {
    {Isa::avx512, "avx512", HWY_AVX3 | HWY_AVX3_DL},
    {Isa::avx2, "avx2", HWY_AVX2},
    {Isa::sse4, "sse4", HWY_SSE4},
    {Isa::scalar, "scalar", HWY_SCALAR | HWY_EMU128},
};

/// Those of `wanted` that are compiled and that the machine can run.
int64_t available(int64_t wanted) {
    static const int64_t machine = hwy::SupportedTargets() | HWY_SCALAR | HWY_EMU128;  // asked once: it is slow
    return wanted & HWY_TARGETS & machine;
}

QueryKernels kernels_of(int64_t targets) {
    hwy::ChosenTarget chosen;
    chosen.Update(targets);
    return HWY_DISPATCH_TABLE(query_kernels)[chosen.GetIndex()]();
}

QueryKernels kernels_for(Isa isa) {
    if (isa == Isa::automatic) return kernels_of(available(HWY_TARGETS));
    std::string wanted, known;
    for (const NamedTargets& named : kNamed) {
        const int64_t targets = available(named.targets);
        if (named.isa == isa && targets != 0) return kernels_of(targets);
        if (named.isa == isa) wanted = named.name;
        if (targets != 0) known += std::string(known.empty() ? "" : ", ") + std::string(named.name);
    }
    throw InputError("isa", "'" + wanted + "' cannot run here, expected one of auto, " + known);
}

}  // namespace

std::vector<Isa> supported_isas() {
    std::vector<Isa> isas;
    for (const NamedTargets& named : kNamed)
        if (available(named.targets) != 0) isas.push_back(named.isa);
    return isas;
}

Isa used_isa(Isa isa) {
    kernels_for(isa);
    return isa == Isa::automatic ? supported_isas().front() : isa;
}

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
