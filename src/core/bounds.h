// SPDX-License-Identifier: MIT
// Axis-aligned boxes. Empty until something is added: lo > hi.
#pragma once

#include "core/math.h"

namespace tress {

template <class Vec>
struct BasicBounds {
    using Scalar = typename Vec::value_type;
    Vec lo{std::numeric_limits<Scalar>::infinity()};
    Vec hi{-std::numeric_limits<Scalar>::infinity()};

    bool empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }
    Vec center() const { return Scalar(0.5) * (lo + hi); }
    Vec extent() const { return hi - lo; }
    bool holds(const Vec& p) const {
        return lo.x <= p.x && p.x <= hi.x && lo.y <= p.y && p.y <= hi.y && lo.z <= p.z && p.z <= hi.z;
    }

    void add(const Vec& point) {
        lo = glm::min(lo, point);
        hi = glm::max(hi, point);
    }
    void add(const BasicBounds& other) {
        lo = glm::min(lo, other.lo);
        hi = glm::max(hi, other.hi);
    }
};

using Bounds = BasicBounds<Vec3>;
using DBounds = BasicBounds<DVec3>;

}  // namespace tress
