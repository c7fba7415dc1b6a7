// SPDX-License-Identifier: MIT
// From optical depths to what cells let through.
#if defined(TRESS_GATHER_PROJECTION_CELL_LIGHT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_GATHER_PROJECTION_CELL_LIGHT_INL_H
#undef TRESS_GATHER_PROJECTION_CELL_LIGHT_INL_H
#else
#define TRESS_GATHER_PROJECTION_CELL_LIGHT_INL_H
#endif

#include "gather/projection/cell_depths.h"
#include "gather/projection/cell_light.h"
#include "gather/projection/near_cells.h"
#include "gather/projection/vector_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

/// Room for whole vectors past the last cell.
inline size_t padded(size_t cells) { return (cells + kMostLanes - 1) / kMostLanes * kMostLanes; }

/// What hair next to the point lets through, to every channel of `to`.
inline void let_through_near(const NearCells& near, size_t cells, bool in_sight, bool gray, CellTransmittance& to) {
    for (int c = 0; c < (gray ? 1 : 3); ++c) {
        if (to.channel[c].size() < padded(cells)) to.channel[c] = AlignedArray<float>(padded(cells));
        for (size_t i = cells; i < padded(cells); ++i) to.channel[c][i] = 0;
    }
    for (size_t i = 0; i < cells; ++i) {
        const Rgbx through = near.through(i, cells, in_sight);
        for (int c = 0; c < (gray ? 1 : 3); ++c) to.channel[c][i] = through.c[c];
    }
}

/// Multiplies `light` by what other hair lets through. `root`: sqrt(T) of each cell, padded with anything. A neighbour
/// beyond the last cell (below a hemisphere's horizon) is the cell itself: no gap, and no opposite neighbours to tell
/// scatter by.
inline void add_gaps(const Igloo& igloo, size_t cells, const float* root, const GapShares& shares, float* light) {
    const Floats d;
    const Ints di;
    const IntVec most = hn::Set(di, int32_t(cells) - 1);
    for (size_t i = 0; i < cells; i += hn::Lanes(d)) {
        const FloatVec own = hn::Load(d, root + i);
        const IntVec self = hn::Min(counted_from(int32_t(i)), most);
        const auto beside = [&](size_t side) {
            const IntVec other = hn::LoadU(di, &igloo.neighbor[side * 2 * igloo.cells] + i);
            return hn::IfThenElse(other > most, self, other);
        };
        FloatVec gap = hn::Zero(d), scatter = hn::Zero(d);  // 8 times the gap; 4 times the scatter
        for (const size_t side : {0, 2}) {                  // and its opposite
            const IntVec there = beside(side), back = beside(side + 1);
            const FloatVec ahead = hn::GatherIndex(d, root, there) - own, behind = hn::GatherIndex(d, root, back) - own;
            const auto alone = hn::RebindMask(d, hn::Or(there == self, back == self));
            const FloatVec both = hn::IfThenZeroElse(alone, ahead + behind);
            gap = gap + ahead * ahead + behind * behind;
            scatter = scatter + both * both;
        }
        const FloatVec added = set(shares.gap / 8) * gap - set(shares.scatter / 4) * scatter;
        hn::Store(hn::Load(d, light + i) * hn::Clamp(own * own + added, hn::Zero(d), set(1.0f)), d, light + i);
    }
}

template <int kChannel, class Depth>
float depth_in(const Depth& depth) {
    if constexpr (sizeof(Depth) == sizeof(float))
        return depth;
    else
        return depth.c[kChannel];
}

template <int kChannel, class Depth>
void find_channel(const Igloo& igloo, const CellDepths<Depth>& depths, size_t cells, bool in_sight,
                  const GapShares& shares, CellTransmittance& to) {
    const Floats d;
    HWY_ALIGN float root[2 * Igloo::kMostCells + kMostLanes];
    for (size_t i = 0; i < cells; ++i) root[i] = depth_in<kChannel>(depths.sum(i));
    if (!in_sight && depths.cells > cells)
        for (size_t i = 0; i < cells; ++i) root[i] += depth_in<kChannel>(depths.sum(cells + i));
    for (size_t i = cells; i < padded(cells); ++i) root[i] = 0;
    for (size_t i = 0; i < cells; i += hn::Lanes(d))
        hn::Store(exp_minus(set(0.5f) * hn::Load(d, root + i)), d, root + i);
    add_gaps(igloo, cells, root, shares, to.channel[kChannel].data());
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
