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

/// Cell of each unit direction given in the frame of the igloo, as cell_of of igloo.h; x and y may both be
/// larger or smaller by one factor.
HWY_INLINE IntVec cells_of(const Igloo& igloo, FloatVec x, FloatVec y, FloatVec z) {
    const Ints di;
    const float cells = float(igloo.cells);
    const IntVec most = hn::Set(di, int32_t(igloo.cells) - 1), zero = hn::Zero(di);
    const IntVec k = hn::Min(hn::Max(nearest_int(set(cells - 0.5f) - set(cells) * hn::Abs(z)), zero), most);
    const IntVec row = hn::GatherIndex(di, igloo.row_of.data(), k);
    const IntVec first = hn::And(row, hn::Set(di, 0xffff)), count = hn::ShiftRight<16>(row);
    const IntVec column = nearest_int(turn_of(x, y) * hn::ConvertTo(Floats(), count) - set(0.5f));
    const IntVec cell = first + hn::Min(column, count - hn::Set(di, 1));
    const auto below_horizon = hn::RebindMask(di, z < hn::Zero(Floats()));
    return cell + hn::IfThenElseZero(below_horizon, hn::Set(di, int32_t(igloo.cells)));
}

/// What a splat is of, and so the depth of one that stops the share x of its cell's light. A fiber crosses a cell in
/// steps of kArcStep, side by side: n of them stop n x, a depth of -log(1 - n x) = n (x + n x^2 / 2 + ...), and chords
/// of a square are such that n is 1.9 in the mean of squares. A cube's hair is many, each of which stops next to
/// nothing.
enum class SplatOf { fiber, cube };

template <SplatOf kOf, class T>
HWY_INLINE T depth_of(T x) {
    if constexpr (kOf == SplatOf::fiber)
        return x + x * x;
    else
        return x;
}

template <SplatOf kOf>
HWY_INLINE void add_depth(float& cell, const Rgbx& opacity, float coverage) {
    cell += depth_of<kOf>(coverage * opacity.c[0]);
}
template <SplatOf kOf>
HWY_INLINE void add_depth(Rgbx& cell, const Rgbx& opacity, float coverage) {
    const hn::CappedTag<float, 4> d;
    for (size_t i = 0; i < 4; i += hn::Lanes(d)) {
        const auto x = hn::Load(d, opacity.c + i) * hn::Set(d, coverage);
        hn::Store(hn::Load(d, cell.c + i) + depth_of<kOf>(x), d, cell.c + i);
    }
}

/// opacity_row of hair_opacity.h.
template <class D>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> opacity_rows(D d, hn::Vec<D> cos_theta) {
    return nearest_int(d, cos_theta * hn::Set(d, float(kOpacityRows - 1)));
}

/// A vector of places about a point, and what is between.
struct SeenPlaces {
    FloatVec x, y, z, squared, inverse;  // squared distance, 1 / distance
};

HWY_INLINE SeenPlaces places(FloatVec x, FloatVec y, FloatVec z) {
    const FloatVec squared = hn::Max(dot3(x, y, z, x, y, z), set(1e-30f));
    return {x, y, z, squared, inverse_sqrt(squared)};
}

/// Cells of splats at `seen`, and the share of each that they cover, to row `at` of `to`; none below the horizon of a
/// hemisphere. Cells of hair behind polygons follow those of all other.
HWY_INLINE void find_cells(const Igloo& igloo, const Viewpoint& from, const SeenPlaces& seen, FloatVec solid_angle,
                           size_t at, CellSplats& to) {
    const Floats d;
    const Ints di;
    const Frame& f = from.frame;
    const FloatVec zero = hn::Zero(d);
    const bool clip = from.dome == Dome::hemisphere;
    const FloatVec x = dot3(set(f.x.x), set(f.x.y), set(f.x.z), seen.x, seen.y, seen.z);
    const FloatVec y = dot3(set(f.y.x), set(f.y.y), set(f.y.z), seen.x, seen.y, seen.z);
    const FloatVec z = dot3(set(f.z.x), set(f.z.y), set(f.z.z), seen.x, seen.y, seen.z) * seen.inverse;
    FloatVec covered =
        solid_angle * set(float(igloo.cells) * (0.5f / kPi));  // in cells; a division here is one a vector
    IntVec cell = cells_of(igloo, x, y, clip ? hn::Max(z, zero) : z);
    if (clip) covered = hn::IfThenElseZero(z >= zero, covered);
    if (!from.sight.empty()) {
        const IntVec all = hn::Set(di, int32_t(igloo.cells_of(from.dome)));
        const auto hidden = seen.squared > hn::GatherIndex(d, from.sight.data(), cell);
        cell = cell + hn::IfThenElseZero(hn::RebindMask(di, hidden), all);
    }
    hn::StoreU(cell, di, &to.cell[at]);
    hn::StoreU(covered, d, &to.coverage[at]);
}

/// Empties `splats`.
template <SplatOf kOf = SplatOf::fiber, class Depth>
void add_to_cells(const HairOpacity& opacity, CellSplats& splats, CellDepths<Depth>& to) {
    Depth* const depth = to.depth.data();
    const Rgbx* const row = opacity.row.data();
    const int32_t* const cell = splats.cell.data();
    const int32_t* const opacity_row = splats.opacity_row.data();
    const float* const coverage = splats.coverage.data();
    const size_t size = splats.size, cells = to.cells;
    constexpr size_t kCopies = CellDepths<Depth>::kCopies;
    size_t i = 0;
    for (; i + kCopies <= size; i += kCopies)
        for (size_t copy = 0; copy < kCopies; ++copy)
            add_depth<kOf>(depth[copy * cells + size_t(cell[i + copy])], row[opacity_row[i + copy]],
                           coverage[i + copy]);
    for (; i < size; ++i) add_depth<kOf>(depth[size_t(cell[i])], row[opacity_row[i]], coverage[i]);
    splats.size = 0;
}

/// Empties `splats`. Cells are found for all of them first, so that neither step waits for the other.
template <SplatOf kOf = SplatOf::fiber, class Depth>
void add_splats(const Igloo& igloo, const Viewpoint& from, const HairOpacity& opacity, Splats& splats,
                CellDepths<Depth>& to) {
    const Floats d;
    for (size_t at = 0; at < splats.size; at += hn::Lanes(d)) {
        const SeenPlaces seen =
            places(hn::Load(d, &splats.x[at]), hn::Load(d, &splats.y[at]), hn::Load(d, &splats.z[at]));
        find_cells(igloo, from, seen, hn::Load(d, &splats.solid_angle[at]), at, splats);
    }
    add_to_cells<kOf>(opacity, splats, to);
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
