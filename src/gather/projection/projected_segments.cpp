// SPDX-License-Identifier: MIT
#include "gather/projection/projected_segments.h"

#include <tbb/parallel_for.h>

namespace tress {

ProjectedSegments make_projected_segments(const SegmentView& segments) {
    ProjectedSegments p;
    p.size = segments.size();
    for (auto* row : {&p.x, &p.y, &p.z, &p.ux, &p.uy, &p.uz, &p.length, &p.radius})
        *row = AlignedArray<float>(p.size + ProjectedSegments::kPadding);
    tbb::parallel_for(size_t(0), p.size, [&](size_t i) {
        const DVec3 a(segments.start(i)), b(segments.end(i));
        const double length = glm::length(b - a);
        const DVec3 middle = 0.5 * (a + b), tangent = (b - a) / length;
        p.x[i] = float(middle.x), p.y[i] = float(middle.y), p.z[i] = float(middle.z);
        p.ux[i] = float(tangent.x), p.uy[i] = float(tangent.y), p.uz[i] = float(tangent.z);
        p.length[i] = float(length);
        p.radius[i] = 0.5f * (segments.start_radius(i) + segments.end_radius(i));
    });
    return p;
}

size_t bytes(const ProjectedSegments& p) { return 8 * p.x.size() * sizeof(float); }

}  // namespace tress
