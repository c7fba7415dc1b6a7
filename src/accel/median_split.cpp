// SPDX-License-Identifier: MIT
#include "accel/median_split.h"

#include <algorithm>

namespace tress {
namespace {

uint32_t longest_axis(const Bounds& cell) {
    const Vec3 e = cell.extent();
    return e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
}

std::optional<Split> split_at(std::span<const Reference> references, const Bounds& cell, const AccelOptions& options,
                              uint32_t axis, float s) {
    const AxisCost cost(options, cell, axis);
    if (!cost.cuts(s)) return std::nullopt;
    uint32_t left = 0, right = 0;
    for (const Reference& r : references) {
        left += r.lo[int(axis)] < s;
        right += r.hi[int(axis)] >= s;
    }
    return Split{axis, s, cost(s, float(left), float(right)), left, right};
}

}  // namespace

std::optional<Split> spatial_median_split(std::span<const Reference> references, const Bounds& cell,
                                          const AccelOptions& options) {
    const uint32_t axis = longest_axis(cell);
    return split_at(references, cell, options, axis, cell.center()[int(axis)]);
}

std::optional<Split> object_median_split(std::span<const Reference> references, const Bounds& cell,
                                         const AccelOptions& options, std::vector<float>& centers) {
    const uint32_t axis = longest_axis(cell);
    centers.resize(references.size());
    for (size_t i = 0; i < references.size(); ++i)
        centers[i] = 0.5f * (references[i].lo[int(axis)] + references[i].hi[int(axis)]);
    const auto middle = centers.begin() + std::ptrdiff_t(centers.size() / 2);
    std::nth_element(centers.begin(), middle, centers.end());
    return split_at(references, cell, options, axis, *middle);
}

}  // namespace tress
