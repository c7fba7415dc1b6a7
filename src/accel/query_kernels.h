// SPDX-License-Identifier: MIT
// The queries as compiled for one instruction set. Only queries.cpp needs this.
#pragma once

#include "accel/queries.h"

namespace tress {

struct QueryKernels {
    void (*nearest_segment)(const KdTree&, const RayBatch&, const NearestHits&);
    void (*nearest_triangle)(const KdTree&, const RayBatch&, const NearestHits&);
    void (*occluded_triangle)(const KdTree&, const RayBatch&, std::span<uint8_t> occluded);
    /// Numbers of crossings, `limit` where there are more.
    void (*count_crossings)(const KdTree&, const RayBatch&, uint32_t limit, std::span<uint32_t> counts);
    void (*transmittance)(const KdTree&, const RayBatch&, const Attenuation&, float cutoff, std::span<Rgb>);
    void (*crossings)(const KdTree&, const RayBatch&, Crossings&);  // appends; first already holds the 0
    void (*flights)(const KdTree&, const RayBatch&, const Attenuation&, std::span<const float> cutoff, Flights&);
};

}  // namespace tress
