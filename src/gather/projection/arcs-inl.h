// SPDX-License-Identifier: MIT
// Pieces of hair, drawn along the arcs that they are seen as, in steps that are small in a cell; those next to the
// point, sample by sample of cells (near_fiber-inl.h, wide_fiber-inl.h).
#if defined(TRESS_GATHER_PROJECTION_ARCS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_GATHER_PROJECTION_ARCS_INL_H
#undef TRESS_GATHER_PROJECTION_ARCS_INL_H
#else
#define TRESS_GATHER_PROJECTION_ARCS_INL_H
#endif

#include <algorithm>
#include <cmath>

#include "gather/projection/add_splats-inl.h"
#include "gather/projection/projection_kernels.h"
#include "gather/projection/wide_fiber-inl.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

inline constexpr float kArcStep = 0.5f;      // of a cell's size, along an arc
inline constexpr float kAlwaysNear = 0.45f;  // of a cell's size: wider pieces are near ones, whatever the option says
inline constexpr float kThinCells = 1.5f;  // and no wider than that, and than kThinWidth, is a near piece that is thin
inline constexpr float kThinWidth = 0.25f;
inline constexpr float kMostArcSteps = 512;  // in half a turn, however small the cells

inline constexpr float kThrough = 2e-5f;  // of its distance: what passes nearer to the point goes through it

/// Signed inclination of the vector with components `across` >= 0 and `along`.
HWY_INLINE FloatVec inclination(FloatVec across, FloatVec along) {
    const FloatVec turn = turn_of(across, along);
    return set(2 * kPi) * hn::IfThenElse(turn > set(0.5f), turn - set(1.0f), turn);
}

/// Makes arcs [0, pieces.size) ready; a piece through the point itself gets any perpendicular.
inline void make_arcs(const PieceList& p, float cell_size, Arcs& arcs) {
    const Floats d;
    const FloatVec tiny = set(1e-30f), one = set(1.0f);
    for (size_t i = 0; i < p.size; i += hn::Lanes(d)) {
        const FloatVec ax = hn::Load(d, &p.ax[i]), ay = hn::Load(d, &p.ay[i]), az = hn::Load(d, &p.az[i]);
        const FloatVec ex = hn::Load(d, &p.bx[i]) - ax, ey = hn::Load(d, &p.by[i]) - ay,
                       ez = hn::Load(d, &p.bz[i]) - az;
        const FloatVec length = hn::Sqrt(hn::Max(dot3(ex, ey, ez, ex, ey, ez), tiny));
        const FloatVec ux = ex / length, uy = ey / length, uz = ez / length;
        const FloatVec along = dot3(ax, ay, az, ux, uy, uz);
        const FloatVec fx = ax - along * ux, fy = ay - along * uy, fz = az - along * uz;
        const FloatVec squared = dot3(fx, fy, fz, fx, fy, fz);
        // An axis that passes through the point, but for the rounding of places in leaves: seen end on it covers
        // nothing. What is across it is any perpendicular, by the axis' smaller components.
        const FloatVec rounding = hn::Load(d, &p.rounding[i]) * set(2.0f) * (one + set(2.0f) * hn::Abs(along) / length);
        const FloatVec nearest =
            hn::Max(rounding * rounding, set(kThrough * kThrough) * dot3(ax, ay, az, ax, ay, az) + tiny);
        const FloatMask through = squared <= nearest;
        const FloatVec foot = hn::Sqrt(hn::IfThenElse(through, tiny, squared));
        const FloatMask flat = hn::Abs(uz) < set(0.7f);
        const FloatVec gx = hn::IfThenElse(flat, uy, uz), gy = hn::IfThenElse(flat, hn::Neg(ux), hn::Zero(d));
        const FloatVec gz = hn::IfThenElse(flat, hn::Zero(d), hn::Neg(ux));
        const FloatVec g = hn::Sqrt(hn::Max(dot3(gx, gy, gz, gx, gy, gz), tiny));
        const FloatVec psi = inclination(foot, along), end = inclination(foot, along + length);
        const FloatVec span = hn::Max(end - psi, hn::Zero(d));
        const FloatVec wanted = hn::Min(span * set(1 / (kArcStep * cell_size)), set(kMostArcSteps));
        const FloatVec steps = hn::Max(hn::Ceil(wanted), one);
        const FloatVec start = hn::Load(d, &p.start_radius[i]), end_radius = hn::Load(d, &p.end_radius[i]);
        const FloatVec radius = set(0.5f) * (start + end_radius);
        const FloatVec sin_width = hn::Min(radius / foot, one);
        const FloatVec width = set(2.0f) * inclination(hn::Sqrt(one - sin_width * sin_width), sin_width);
        const FloatVec step = span / steps;
        hn::Store(ux, d, &arcs.ux[i]), hn::Store(uy, d, &arcs.uy[i]), hn::Store(uz, d, &arcs.uz[i]);
        hn::Store(hn::IfThenElse(through, gx / g, fx / foot), d, &arcs.nx[i]);
        hn::Store(hn::IfThenElse(through, gy / g, fy / foot), d, &arcs.ny[i]);
        hn::Store(hn::IfThenElse(through, gz / g, fz / foot), d, &arcs.nz[i]);
        hn::Store(foot, d, &arcs.foot[i]), hn::Store(along, d, &arcs.along[i]), hn::Store(length, d, &arcs.length[i]);
        hn::Store(psi, d, &arcs.psi[i]), hn::Store(step, d, &arcs.step[i]), hn::Store(steps, d, &arcs.steps[i]);
        hn::Store(width, d, &arcs.width[i]);
        hn::Store(width * set(2.0f) * sine(set(0.5f) * step), d, &arcs.solid[i]);
        hn::Store((end_radius - start) / hn::Max(radius * length, tiny), d, &arcs.taper[i]);
    }
}

/// Appends the steps of an arc; there must be room for them.
HWY_INLINE void draw_arc(const ArcRow& arc, Splats& to) {
    const Floats d;
    const Ints di;
    const FloatVec zero = hn::Zero(d), one = set(1.0f), solid = set(arc.solid);
    const FloatVec second_order = set(arc.width * arc.width / 24);
    for (size_t i = 0; i < arc.steps; i += hn::Lanes(d)) {
        const FloatVec place = counted_from(float(i) + 0.5f);
        const FloatVec psi = hn::Clamp(set(arc.psi) + place * set(arc.step), set(-kPi / 2), set(kPi / 2));
        const FloatVec sin_psi = sine(psi);
        const FloatVec cos_squared = hn::Max(one - sin_psi * sin_psi, set(1e-12f));
        const FloatVec inverse_cos = inverse_sqrt(cos_squared), cos_psi = cos_squared * inverse_cos;
        // The ends of a wide lune lie nearer at its edges: sin psi grows by cos^2 psi width^2 / 24 on average.
        const FloatVec at_edges = one + second_order * (set(3.0f) * cos_squared - set(2.0f));
        FloatVec covered = solid * cos_psi * at_edges;
        if (arc.taper != 0) {
            const FloatVec s = hn::Clamp(set(arc.foot) * sin_psi * inverse_cos - set(arc.along), zero, set(arc.length));
            const FloatVec in_means = one + set(arc.taper) * (s - set(0.5f * arc.length));
            covered = covered * in_means;
        }
        const FloatVec distance = set(arc.foot) * inverse_cos;
        const FloatVec along = distance * sin_psi, across = distance * cos_psi;
        hn::StoreU(along * set(arc.axis.x) + across * set(arc.normal.x), d, &to.x[to.size + i]);
        hn::StoreU(along * set(arc.axis.y) + across * set(arc.normal.y), d, &to.y[to.size + i]);
        hn::StoreU(along * set(arc.axis.z) + across * set(arc.normal.z), d, &to.z[to.size + i]);
        hn::StoreU(covered, d, &to.solid_angle[to.size + i]);
        hn::StoreU(opacity_rows(d, cos_psi) + hn::Set(di, arc.first_opacity_row), di, &to.opacity_row[to.size + i]);
    }
    to.size += arc.steps;
}

inline ArcRow arc_of(const PieceList& pieces, const Arcs& arcs, size_t i) {
    ArcRow row;
    row.axis = {arcs.ux[i], arcs.uy[i], arcs.uz[i]};
    row.normal = {arcs.nx[i], arcs.ny[i], arcs.nz[i]};
    row.foot = arcs.foot[i], row.along = arcs.along[i], row.length = arcs.length[i];
    row.psi = arcs.psi[i], row.step = arcs.step[i], row.steps = size_t(arcs.steps[i]);
    row.width = arcs.width[i], row.solid = arcs.solid[i], row.taper = arcs.taper[i];
    row.radius = 0.5f * (pieces.start_radius[i] + pieces.end_radius[i]);
    row.first_opacity_row = pieces.kind[i] * kOpacityRows;
    row.segment = pieces.segment[i];
    return row;
}

/// Whether samples of cells are asked what the arc covers. It is widest where it is nearest to the foot; one that is
/// wide at the foot itself is no thin strip anywhere.
inline bool is_near(const ArcRow& arc, float near, float cell_size) {
    if (arc.width > kAlwaysNear * cell_size) return true;
    const float place = std::max({arc.along, -arc.along - arc.length, 0.0f});
    return square(arc.width * arc.foot) > square(near * cell_size) * (square(arc.foot) + square(place));
}

/// Draws scratch.pieces and empties the list; near ones are kept for finish_pieces.
template <class Depth>
void draw_pieces(const ProjectionInput& in, const Viewpoint& from, ProjectionScratch& scratch, CellDepths<Depth>& to) {
    const float cell_size = in.igloo.cell_size();
    PieceList& pieces = scratch.pieces;
    make_arcs(pieces, cell_size, scratch.arcs);
    for (size_t i = 0; i < pieces.size; ++i) {
        const ArcRow arc = arc_of(pieces, scratch.arcs, i);
        if (is_near(arc, in.near, cell_size)) {
            scratch.near_arcs.push_back(arc);
            continue;
        }
        if (!scratch.splats.has_room(arc.steps)) add_splats(in.igloo, from, in.opacity, scratch.splats, to);
        draw_arc(arc, scratch.splats);
    }
    pieces.size = 0;
}

inline float end_of(const ArcRow& arc) { return arc.along + arc.length; }

/// One arc in place of those of a segment from order[i] on that follow each other without a gap; i becomes that of the
/// next.
inline ArcRow next_near(const std::vector<ArcRow>& arcs, const std::vector<NearOrder>& order, size_t& i) {
    const auto from_foot = [](const ArcRow& arc) { return std::max({arc.along, -end_of(arc), 0.0f}); };
    const auto radius_at = [](const ArcRow& arc, float place) {
        return arc.radius * (1 + arc.taper * (place - arc.along - 0.5f * arc.length));
    };
    const ArcRow& first = arcs[order[i].arc];
    const ArcRow *high = &first, *middle = &first;  // the farthest, and the nearest to the foot
    size_t count = 1;
    for (++i; i < order.size(); ++i, ++count) {
        const ArcRow& arc = arcs[order[i].arc];
        if (arc.segment != first.segment || arc.along > end_of(*high) + 0.01f * first.radius) break;
        if (end_of(arc) > end_of(*high)) high = &arc;
        if (from_foot(arc) < from_foot(*middle)) middle = &arc;
    }
    if (count == 1) return first;
    const float start = first.along, end = end_of(*high);
    const float start_radius = radius_at(first, start), end_radius = radius_at(*high, end);
    ArcRow whole = *middle;  // knows best which way the foot is
    whole.along = start, whole.length = end - start;
    whole.radius = 0.5f * (start_radius + end_radius);
    whole.taper = (end_radius - start_radius) / std::max(whole.radius * whole.length, 1e-30f);
    whole.width = 2 * std::asin(std::min(whole.radius / whole.foot, 1.0f));
    return whole;
}

/// Draws what is left of a point's pieces. Near ones come segment by segment, whichever cubes a tree has cut them into.
template <class Depth>
void finish_pieces(const ProjectionInput& in, const Viewpoint& from, ProjectionScratch& scratch,
                   CellDepths<Depth>& to) {
    draw_pieces(in, from, scratch, to);
    add_splats(in.igloo, from, in.opacity, scratch.splats, to);
    const std::vector<ArcRow>& arcs = scratch.near_arcs;
    std::vector<NearOrder>& order = scratch.near_order;
    order.clear();
    for (size_t i = 0; i < arcs.size(); ++i) order.emplace_back(arcs[i], uint32_t(i));
    std::sort(order.begin(), order.end());
    const float widest = std::sin(0.5f * std::min(kThinCells * in.igloo.cell_size(), kThinWidth));
    for (size_t i = 0; i < order.size();) {
        const ArcRow arc = next_near(arcs, order, i);
        const float largest_radius = arc.radius * (1 + 0.5f * std::abs(arc.taper) * arc.length);
        if (largest_radius <= widest * arc.foot)
            cover_thin(in.igloo, from, in.opacity, arc, scratch);
        else
            cover_wide(in.igloo, from, in.opacity, arc, scratch);
    }
    scratch.near_arcs.clear();
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
