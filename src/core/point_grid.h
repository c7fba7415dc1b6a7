// SPDX-License-Identifier: MIT
// The nearest of many points, found through a grid of cells.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/bounds.h"

namespace tress {

class PointGrid {
public:
    /// Over `points`, at least one, all finite; they are copied.
    explicit PointGrid(std::span<const Vec3> points);

    /// Index of the point nearest to `p`; ties: the smaller index.
    uint32_t nearest(const Vec3& p) const;

private:
    glm::ivec3 cell_of(const Vec3& p) const;
    size_t index(const glm::ivec3& c) const { return (size_t(c.z) * cells_.y + c.y) * cells_.x + c.x; }

    std::vector<Vec3> points_;
    Bounds box_;
    float cell_ = 1;
    glm::ivec3 cells_{1};
    std::vector<uint32_t> first_, member_;  // members of cell c: member_[first_[c] .. first_[c + 1])
};

}  // namespace tress
