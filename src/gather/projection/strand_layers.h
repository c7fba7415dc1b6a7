// SPDX-License-Identifier: MIT
// The paper's distance-based levels of detail (Yuksel, Akleman & Keyser 2007, sec. 4.2): what is in layer i, at
// distances [(i - 1) s, i s), projects every i-th segment, from a phase hashed a strand: a fixed one would pick roots
// alone where i divides the strand. Weighted, each segment kept stands for i, which keeps the mean optical depth; the
// paper leaves this out, and 1 - 1/i of the occlusion is lost.
#pragma once

#include "core/options.h"
#include "core/segments.h"
#include "gather/projection/projection_scratch.h"

namespace tress {

struct StrandLayers {
    std::vector<uint32_t> first;  // segment of each strand, and one past the last
    std::vector<Vec3> root;       // one a strand
    std::vector<float> phase;     // one a strand, [0, 1)
    std::vector<float> shift;     // likewise: of the layers' edges
};

StrandLayers make_strand_layers(const SegmentView& segments);

/// Segments that are projected from a point, in order.
void choose_segments(const StrandLayers& layers, const SegmentView& segments, const ProjectionOptions& options,
                     const Vec3& point, std::vector<ChosenSegment>& chosen);

size_t bytes(const StrandLayers& layers);

}  // namespace tress
