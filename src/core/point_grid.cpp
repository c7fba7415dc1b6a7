// SPDX-License-Identifier: MIT
#include "core/point_grid.h"

#include <algorithm>

namespace tress {
namespace {

constexpr int kMostCells = 64;  // along an axis

}  // namespace

PointGrid::PointGrid(std::span<const Vec3> points) : points_(points.begin(), points.end()) {
    for (const Vec3& p : points_) box_.add(p);
    // As many cells along the longest side as make about one point a cell where the points lie on a surface.
    const float longest = max_component(box_.extent());
    const float wanted = glm::clamp(std::sqrt(float(points_.size())), 1.0f, float(kMostCells));
    cell_ = longest > 0 ? longest / wanted : 1;
    cells_ = glm::ivec3(glm::floor(box_.extent() / cell_)) + 1;

    first_.assign(size_t(cells_.x) * cells_.y * cells_.z + 1, 0);
    for (const Vec3& p : points_) ++first_[index(cell_of(p)) + 1];
    for (size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    std::vector<uint32_t> next(first_.begin(), first_.end() - 1);
    member_.resize(points_.size());
    for (uint32_t i = 0; i < points_.size(); ++i) member_[next[index(cell_of(points_[i]))]++] = i;
}

glm::ivec3 PointGrid::cell_of(const Vec3& p) const {
    return glm::clamp(glm::ivec3(glm::floor((p - box_.lo) / cell_)), glm::ivec3(0), cells_ - 1);
}

uint32_t PointGrid::nearest(const Vec3& p) const {
    const glm::ivec3 middle = cell_of(p);
    uint32_t best = 0;
    float best2 = kInfinity;
    const auto visit = [&](const glm::ivec3& c) {
        for (uint32_t m = first_[index(c)]; m < first_[index(c) + 1]; ++m) {
            const Vec3 d = points_[member_[m]] - p;
            const float d2 = dot(d, d);
            if (d2 < best2 || (d2 == best2 && member_[m] < best)) best = member_[m], best2 = d2;
        }
    };
    const int farthest = std::max({cells_.x, cells_.y, cells_.z});
    for (int ring = 0; ring <= farthest; ++ring) {
        // What lies `ring` cells away is at least ring - 1 cells' widths distant.
        if (ring > 0 && best2 < square((ring - 1) * cell_)) break;
        const glm::ivec3 lo = glm::max(middle - ring, glm::ivec3(0)), hi = glm::min(middle + ring, cells_ - 1);
        for (int z = lo.z; z <= hi.z; ++z) {
            for (int y = lo.y; y <= hi.y; ++y) {
                const bool whole_row = std::abs(z - middle.z) == ring || std::abs(y - middle.y) == ring;
                for (int x = lo.x; x <= hi.x; ++x) {
                    if (whole_row || std::abs(x - middle.x) == ring) visit({x, y, z});
                }
            }
        }
    }
    return best;
}

}  // namespace tress
