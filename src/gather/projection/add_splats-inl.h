// SPDX-License-Identifier: MIT
// Splats into cells: directions are turned into the igloo's frame, their cells found, their optical depths added.
#if defined(TRESS_GATHER_PROJECTION_ADD_SPLATS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_GATHER_PROJECTION_ADD_SPLATS_INL_H
#undef TRESS_GATHER_PROJECTION_ADD_SPLATS_INL_H
#else
#define TRESS_GATHER_PROJECTION_ADD_SPLATS_INL_H
#endif

#include "gather/projection/cell_depths.h"
#include "gather/projection/splats.h"
#include "gather/projection/vector_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

/// Cell of each unit direction given in the frame of the igloo, as cell_of of igloo.h.
HWY_INLINE IntVec cells_of(const Igloo& igloo, FloatVec x, FloatVec y, FloatVec z) {
    const Ints di;
    const IntVec most = hn::Set(di, int32_t(igloo.cells) - 1), zero = hn::Zero(di);
    const FloatVec below = set(float(igloo.cells)) * (set(1.0f) - hn::Abs(z));
    const IntVec k = hn::Min(hn::Max(hn::ConvertTo(di, below), zero), most);
    const IntVec row = hn::GatherIndex(di, igloo.row_of.data(), k);
    const IntVec first = hn::And(row, hn::Set(di, 0xffff)), count = hn::ShiftRight<16>(row);
    const FloatVec column = turn_of(x, y) * hn::ConvertTo(Floats(), count);
    const IntVec cell = first + hn::Min(hn::ConvertTo(di, column), count - hn::Set(di, 1));
    const IntVec below_horizon = hn::ShiftRight<31>(hn::BitCast(di, z));  // -1 or 0
    return cell + hn::And(below_horizon, hn::Set(di, int32_t(igloo.cells)));
}

/// -log(1 - x) for x in [0, 1), by its first terms: a piece that covers much of a cell is cut up before it comes here.
HWY_INLINE float depth_of(float x) { return x * (1 + x * (0.5f + x * (1 / 3.0f))); }

HWY_INLINE void add_depth(float& cell, const Rgbx& opacity, float coverage) {
    cell += depth_of(coverage * opacity.c[0]);
}
HWY_INLINE void add_depth(Rgbx& cell, const Rgbx& opacity, float coverage) {
    for (int c = 0; c < 4; ++c) cell.c[c] += depth_of(coverage * opacity.c[c]);
}

/// Empties `splats`. Pieces below the horizon of a hemisphere are not seen.
template <class Depth>
void add_splats(const Igloo& igloo, const Viewpoint& from, const HairOpacity& opacity, Splats& splats,
                CellDepths<Depth>& to) {
    const Floats d;
    const Ints di;
    const size_t lanes = hn::Lanes(d);
    const Frame& f = from.frame;
    const FloatVec per_cell = set(1 / igloo.solid_angle());
    const bool clip = from.dome == Dome::hemisphere;
    HWY_ALIGN int32_t cell[kMostLanes];
    HWY_ALIGN float coverage[kMostLanes];
    for (size_t at = 0; at < splats.size; at += lanes) {
        const FloatVec x = hn::Load(d, &splats.x[at]), y = hn::Load(d, &splats.y[at]), z = hn::Load(d, &splats.z[at]);
        const FloatVec inverse = inverse_sqrt(dot3(x, y, z, x, y, z));
        const FloatVec local_x = dot3(set(f.x.x), set(f.x.y), set(f.x.z), x, y, z) * inverse;
        const FloatVec local_y = dot3(set(f.y.x), set(f.y.y), set(f.y.z), x, y, z) * inverse;
        const FloatVec local_z = dot3(set(f.z.x), set(f.z.y), set(f.z.z), x, y, z) * inverse;
        FloatVec covered = hn::Load(d, &splats.solid_angle[at]) * per_cell;
        FloatVec height = local_z;
        if (clip) {
            covered = hn::IfThenElseZero(local_z >= hn::Zero(d), covered);
            height = hn::Max(local_z, hn::Zero(d));
        }
        hn::Store(cells_of(igloo, local_x, local_y, height), di, cell);
        hn::Store(covered, d, coverage);
        const size_t count = splats.size - at < lanes ? splats.size - at : lanes;
        for (size_t i = 0; i < count; ++i) {
            const size_t copy = (at + i) % CellDepths<Depth>::kCopies;
            const Rgbx& o = opacity.row[size_t(splats.opacity_row[at + i])];
            add_depth(to.depth[copy * to.cells + size_t(cell[i])], o, coverage[i]);
        }
    }
    splats.size = 0;
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
