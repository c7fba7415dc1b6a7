// SPDX-License-Identifier: MIT
// What parts of a render take, by which the costs of methods are told beforehand. Measured on one core of an Intel Xeon
// (Sapphire Rapids, AVX-512; projection: AMD EPYC, AVX-512); docs/light.md and docs/projection.md say how. Other
// machines scale all of them alike.
#pragma once

namespace tress {

inline constexpr double kShadeSeconds = 0.45e-6;     // a way to a light, without what is between
inline constexpr double kRaySeconds = 0.94e-6;       // a ray from hair, and
inline constexpr double kCrossingSeconds = 0.43e-6;  // each fiber that it crosses

// Type 1 by shadow maps.
inline constexpr double kAskSeconds = 1.1e-6;        // a short ray and a look-up
inline constexpr double kSegmentSeconds = 0.72e-6;   // a segment put on a map, and
inline constexpr double kFragmentSeconds = 0.27e-6;  // each texel that it touches

// Type 2.
inline constexpr double kPolygonRaySeconds = 1.3e-6;        // a ray from a polygon
inline constexpr double kDirectionSeconds = 0.25e-6;        // a direction seen through its cell
inline constexpr double kProjectedSegmentSeconds = 4.2e-9;  // a segment projected
inline constexpr double kWalkSeconds = 117e-6;              // a walk of the tree: 256 cells, opening 3, and
inline constexpr double kWalkSegments = 1.2e6;              // as many segments
inline constexpr double kSampledSeconds = 13e-6;            // of it, for samples of cells next to the point
inline constexpr double kNearSeconds = 50e-6;               // the hair next to a point alone, and
inline constexpr double kNearShare = 0.25;                  // of the whole walk
inline constexpr double kTreeSegmentSeconds = 1.5e-6;       // a segment put into the tree
inline constexpr double kTrialSeconds = 4.7e-3;             // a point at which the gap is found, by rays, and
inline constexpr double kTrialWalks = 3;                    // how often it is projected meanwhile
inline constexpr double kProbeRaySeconds = 0.85e-6;         // a ray of a probe

}  // namespace tress
