// SPDX-License-Identifier: MIT
// What the tests of projection share: hair seen alike on all instruction sets, and what should be seen of it.
#pragma once

#include <doctest/doctest.h>

#include "accel/isa_targets.h"
#include "tools/check/support/projected_hair.h"

namespace tress::test {

/// Transmittance of every cell, which must be the same to the bit on all instruction sets.
inline std::vector<Rgb> seen(const ProjectedHair& hair, const Viewpoint& from, const Unseen& unseen = {}) {
    std::vector<Rgb> first;
    for (const Isa isa : supported_isas()) {
        CAPTURE(isa_name(isa));
        const std::vector<Rgb> cells = seen_with(isa, hair, from, unseen);
        if (first.empty()) first = cells;
        REQUIRE(cells == first);
    }
    REQUIRE(first.size() == hair.projection.igloo.cells_of(from.dome));
    return first;
}

inline double mean_difference(const std::vector<Rgb>& a, const std::vector<Rgb>& b) {
    REQUIRE(a.size() == b.size());
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += std::abs(double(mean(a[i])) - double(mean(b[i])));
    return sum / double(a.size());
}

/// What a segment lets through along a unit direction from a point, by the formula alone: all, unless the direction's
/// closest approach to the axis lies ahead, beside the axis, and within the radius that the fiber has there.
inline DVec3 through_segment(const SegmentView& hair, uint32_t segment, const Attenuation& attenuation,
                             const DVec3& from, const DVec3& w) {
    const DVec3 a = DVec3(hair.start(segment)) - from, axis = DVec3(hair.end(segment)) - DVec3(hair.start(segment));
    const double whole = length(axis), cosine = dot(w, axis) / whole, sine2 = 1 - cosine * cosine;
    if (!(sine2 > 1e-14)) return DVec3(1);
    const DVec3 u = axis / whole;
    const double aw = dot(a, w), au = dot(a, u);
    const double t = (aw - au * cosine) / sine2, s = (aw * cosine - au) / sine2;
    if (!(t > 0) || s < 0 || s > whole) return DVec3(1);
    const double radius = glm::mix(double(hair.start_radius(segment)), double(hair.end_radius(segment)), s / whole);
    const DVec3 off = a + s * u - t * w;
    if (dot(off, off) > radius * radius) return DVec3(1);
    return exp(-DVec3(attenuation.depth(segment, float(std::abs(cosine)))));
}

/// Mean over n x n jittered directions in each cell of what all segments let through.
inline std::vector<Rgb> expected(const ProjectedHair& hair, const Viewpoint& from, int n) {
    const Igloo& igloo = hair.projection.igloo;
    const SegmentView segments = hair.segments();
    std::vector<Rgb> cells;
    for (uint32_t cell = 0; cell < igloo.cells_of(from.dome); ++cell) {
        DVec3 sum(0);
        for (int i = 0; i < n * n; ++i) {
            const uint64_t key = hash(hash(21, cell), uint64_t(i));
            const Vec2 u((float(i / n) + random(key, 0)) / float(n), (float(i % n) + random(key, 1)) / float(n));
            const DVec3 w = normalize(DVec3(from.frame.to_world(direction_in(igloo, cell, u))));
            DVec3 through(1);
            for (uint32_t s = 0; s < segments.size(); ++s)
                through *= through_segment(segments, s, hair.attenuation, DVec3(from.position), w);
            sum += through;
        }
        cells.push_back(Rgb(sum / double(n * n)));
    }
    return cells;
}

}  // namespace tress::test
