// SPDX-License-Identifier: MIT
#include "gather/projection/projected_segments.h"

#include <tbb/parallel_for.h>

namespace tress {

ProjectedSegments::ProjectedSegments(size_t rows) : values(rows * kColumns), stream(rows / kStreams) {}

ProjectedSegments make_projected_segments(const SegmentView& segments) {
    using P = ProjectedSegments;
    P p((segments.size() + P::kStreams - 1) / P::kStreams * P::kStreams);
    tbb::parallel_for(size_t(0), p.rows(), [&](size_t i) {
        const size_t segment = p.segment_of(i);
        if (segment >= segments.size()) return;
        const DVec3 a(segments.start(segment)), b(segments.end(segment));
        const double length = glm::length(b - a);
        const DVec3 middle = 0.5 * (a + b), tangent = (b - a) / length;
        p.at(i, P::kX) = float(middle.x), p.at(i, P::kY) = float(middle.y), p.at(i, P::kZ) = float(middle.z);
        p.at(i, P::kUx) = float(tangent.x), p.at(i, P::kUy) = float(tangent.y), p.at(i, P::kUz) = float(tangent.z);
        p.at(i, P::kLength) = float(length);
        p.at(i, P::kRadius) = 0.5f * (segments.start_radius(segment) + segments.end_radius(segment));
        p.at(i, P::kTaper) = 0.5f * (segments.end_radius(segment) - segments.start_radius(segment));
        p.set_original(i, uint32_t(segment));
    });
    return p;
}

size_t bytes(const ProjectedSegments& p) { return p.values.size() * sizeof(float); }

}  // namespace tress
