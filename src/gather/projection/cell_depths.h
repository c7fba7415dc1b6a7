// SPDX-License-Identifier: MIT
// Optical depth of the hair in each cell about a point, as a sum over pieces of hair in any number of calls.
#pragma once

#include <span>

#include "core/aligned_array.h"
#include "core/frame.h"
#include "gather/projection/far_hair.h"
#include "gather/projection/hair_opacity.h"
#include "gather/projection/igloo.h"

namespace tress {

/// Depth is float (gray hair) or Rgbx. Neighbouring pieces often fall in one cell: they are added to copies of it in
/// turn, by their place in the list, so that additions need not wait for each other.
template <class Depth>
struct CellDepths {
    static constexpr size_t kCopies = sizeof(Depth) == sizeof(float) ? 4 : 2;

    AlignedArray<Depth> depth;  // kCopies x cells
    size_t cells = 0;           // of the dome; those of hair out of sight follow, where there are polygons

    void clear(size_t of_cells) {
        cells = of_cells;
        if (depth.size() < kCopies * cells) depth = AlignedArray<Depth>(kCopies * cells);
        for (size_t i = 0; i < kCopies * cells; ++i) depth[i] = Depth{};
    }
    /// Starts with the depths of far hair.
    void start(const FarHair& far) {
        clear(far.depth.size());
        const auto value = unpacked_depths();
        for (size_t cell = 0; cell < cells; ++cell) {
            const uint32_t bits = far.depth[cell].bits;
            if constexpr (sizeof(Depth) == sizeof(float))
                depth[cell] = value[bits & 1023];
            else
                depth[cell] = {value[bits & 1023], value[bits >> 10 & 1023], value[bits >> 20 & 1023], 0};
        }
    }
    Depth sum(size_t cell) const {
        Depth all = depth[cell];
        for (size_t copy = 1; copy < kCopies; ++copy) all += depth[copy * cells + cell];
        return all;
    }
};

/// Where a point stands: its place, and how its igloo is turned.
struct Viewpoint {
    Vec3 position{0};
    Frame frame;  // z: the pole
    Dome dome = Dome::sphere;
    std::span<const float> sight =
        {};  // squared distance of polygons among the hair, one a cell; empty: there are none
};

/// What projection does not see from a point: its own fiber, by identity (segments [first, last]; none: first > last).
struct Unseen {
    uint32_t first = 1, last = 0;
    Bounds box;  // of them

    bool any() const { return first <= last; }
    /// Any of `count` segments from this one on.
    bool holds(uint32_t segment, uint32_t count = 1) const {
        return any() && segment + count > first && segment <= last;
    }
};

}  // namespace tress
