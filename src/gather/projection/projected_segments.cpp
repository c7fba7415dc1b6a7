// SPDX-License-Identifier: MIT
#include "gather/projection/projected_segments.h"

#include <tbb/parallel_for.h>

namespace tress {

ProjectedSegments make_rows(size_t rows) {
    ProjectedSegments p;
    p.stream = rows / ProjectedSegments::kStreams;
    for (auto* row : {&p.x, &p.y, &p.z, &p.ux, &p.uy, &p.uz, &p.length, &p.radius, &p.taper})
        *row = AlignedArray<float>(rows);
    return p;
}

ProjectedSegments make_projected_segments(const SegmentView& segments) {
    constexpr size_t streams = ProjectedSegments::kStreams;
    ProjectedSegments p = make_rows((segments.size() + streams - 1) / streams * streams);
    p.segments = segments.size();
    tbb::parallel_for(size_t(0), p.rows(), [&](size_t i) {
        const size_t segment = p.segment_of(i);
        if (segment >= p.segments) return;
        const DVec3 a(segments.start(segment)), b(segments.end(segment));
        const double length = glm::length(b - a);
        const DVec3 middle = 0.5 * (a + b), tangent = (b - a) / length;
        p.x[i] = float(middle.x), p.y[i] = float(middle.y), p.z[i] = float(middle.z);
        p.ux[i] = float(tangent.x), p.uy[i] = float(tangent.y), p.uz[i] = float(tangent.z);
        p.length[i] = float(length);
        p.radius[i] = 0.5f * (segments.start_radius(segment) + segments.end_radius(segment));
        p.taper[i] = 0.5f * (segments.end_radius(segment) - segments.start_radius(segment));
    });
    return p;
}

size_t bytes(const ProjectedSegments& p) {
    return 9 * p.x.size() * sizeof(float) + p.original.capacity() * sizeof(uint32_t);
}

}  // namespace tress
