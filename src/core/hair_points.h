// SPDX-License-Identifier: MIT
// Points spread evenly over hair.
#pragma once

#include <vector>

#include "core/segments.h"

namespace tress {

struct HairPoints {
    std::vector<Vec3> position;  // on the axes
    float area = 0;              // diameter x length that each stands for
};

/// `n` of them, by area: one in each n-th part of all hair laid end to end, at a hashed place in it, so that equal
/// strands do not get theirs at equal places. None where the hair has no area.
HairPoints spread_points(const SegmentView& segments, size_t n);

}  // namespace tress
