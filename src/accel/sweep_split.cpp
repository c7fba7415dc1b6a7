// SPDX-License-Identifier: MIT
#include "accel/sweep_split.h"

#include <algorithm>

namespace tress {

std::optional<Split> sweep_split(std::span<const Reference> references, const Bounds& cell, const AccelOptions& options,
                                 SortedFaces& faces) {
    std::optional<Split> best;
    faces.lo.resize(references.size());
    faces.hi.resize(references.size());
    for (uint32_t axis = 0; axis < 3; ++axis) {
        for (size_t i = 0; i < references.size(); ++i) {
            faces.lo[i] = references[i].lo[int(axis)];
            faces.hi[i] = references[i].hi[int(axis)];
        }
        std::sort(faces.lo.begin(), faces.lo.end());
        std::sort(faces.hi.begin(), faces.hi.end());
        sweep_axis<float>(faces.lo, faces.hi, AxisCost(options, cell, axis), axis, best);
    }
    return best;
}

}  // namespace tress
