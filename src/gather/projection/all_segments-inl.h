// SPDX-License-Identifier: MIT
// Every segment projected: one splat for those that are small from the point, four for those that are not much longer,
// exact arcs for the rest.
#if defined(TRESS_GATHER_PROJECTION_ALL_SEGMENTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_GATHER_PROJECTION_ALL_SEGMENTS_INL_H
#undef TRESS_GATHER_PROJECTION_ALL_SEGMENTS_INL_H
#else
#define TRESS_GATHER_PROJECTION_ALL_SEGMENTS_INL_H
#endif

#include <bit>

#include "gather/projection/arcs-inl.h"
#include "gather/projection/projection_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

/// One splat stands for a segment of at most this length, in distances; longer ones than a cell are cut up.
HWY_INLINE float longest_splat(float cell_size) { return std::min(cell_size, 0.25f); }

/// Four splats stand for one of at most this length, whose quarters are nearly as far away as its middle.
HWY_INLINE float longest_quartered(float cell_size) { return std::min(4 * longest_splat(cell_size), 0.5f); }

/// No splat stands for one that looks wider. A point's own fiber, which reaches kOwnStrandRadii along the strand, is
/// longer or wider than this from it in any case, so that leaving it out is left to what is not one splat.
HWY_INLINE float widest_splat(float cell_size) { return std::min(kWideShare * cell_size, 0.1f); }

/// A vector of segments: middles relative to the point, tangents.
struct SeenSegments {
    SeenPlaces middle;
    FloatVec ux, uy, uz, length, radius;
};

/// Those from row `i` on, whole; where `place` is not 0, their parts of a `share` of their length about this place on
/// them, from -1 to 1.
HWY_INLINE SeenSegments look_at(const ProjectedSegments& s, size_t i, const Viewpoint& from, float place = 0,
                                float share = 1) {
    const Floats d;
    const FloatVec ux = hn::Load(d, &s.ux[i]), uy = hn::Load(d, &s.uy[i]), uz = hn::Load(d, &s.uz[i]);
    FloatVec x = hn::Load(d, &s.x[i]) - set(from.position.x), y = hn::Load(d, &s.y[i]) - set(from.position.y),
             z = hn::Load(d, &s.z[i]) - set(from.position.z);
    FloatVec length = hn::Load(d, &s.length[i]), radius = hn::Load(d, &s.radius[i]);
    if (place != 0) {
        const FloatVec along = set(0.5f * place) * length;
        x = x + along * ux, y = y + along * uy, z = z + along * uz;
        radius = radius + set(place) * hn::Load(d, &s.taper[i]);
        length = set(share) * length;
    }
    return {places(x, y, z), ux, uy, uz, length, radius};
}

/// A vector of segments as one splat each, at rows `at` and on: solid angle 2 r L sin(alpha) / d^2 (1 + (5 g^2 - L^2) /
/// (8 d^2)), with alpha the angle between tangent and direction and g = L cos(alpha): the integral over the axis up to
/// the fourth power of L / d. Where `left_out`, it is 0.
HWY_INLINE void splat_segments(const Igloo& igloo, const Viewpoint& from, const SeenSegments& v, FloatMask left_out,
                               size_t at, CellSplats& to) {
    const Ints di;
    const FloatVec one = set(1.0f);
    const auto& [x, y, z, squared, inverse] = v.middle;
    const FloatVec inverse_squared = inverse * inverse;
    const FloatVec cosine = dot3(x, y, z, v.ux, v.uy, v.uz) * inverse;
    // By the cross product: 1 - cosine^2 has no digits left where they are nearly parallel.
    const FloatVec cx = y * v.uz - z * v.uy, cy = z * v.ux - x * v.uz, cz = x * v.uy - y * v.ux;
    const FloatVec sine_squared = hn::Min(dot3(cx, cy, cz, cx, cy, cz) * inverse_squared, one);
    const FloatVec sine_alpha = hn::Sqrt(sine_squared);
    const FloatVec in_distances = v.length * v.length * inverse_squared;
    const FloatVec higher = one + set(0.125f) * in_distances * (set(5.0f) * cosine * cosine - one);
    const FloatVec solid = set(2.0f) * v.radius * v.length * sine_alpha * inverse_squared * higher;
    find_cells(igloo, from, v.middle, hn::IfThenZeroElse(left_out, solid), at, to);
    const FloatVec row = sine_alpha * set(float(kOpacityRows - 1)) + set(0.5f);
    hn::StoreU(hn::ConvertTo(di, row), di, &to.opacity_row[at]);
}

/// Segments too near for one splat, by a bit each: those of which four parts are splats, and those that are not.
struct NearSegments {
    uint32_t quartered = 0, pieces = 0;
};

/// kMostLanes rows of `s` from `first` on as splats past the last of `to`, but for those too near.
HWY_INLINE NearSegments splat_rows(const Igloo& igloo, const ProjectedSegments& s, size_t first, const Viewpoint& from,
                                   CellSplats& to) {
    const Floats d;
    const float cell_size = igloo.cell_size();
    const float longest = longest_splat(cell_size), quartered = longest_quartered(cell_size);
    const float widest = widest_splat(cell_size);
    NearSegments near;
    for (size_t i = 0; i < kMostLanes; i += hn::Lanes(d)) {
        const SeenSegments v = look_at(s, first + i, from);
        const FloatVec squared = v.middle.squared, length = v.length * v.length,
                       width = set(4.0f) * v.radius * v.radius;
        const FloatMask wide = width > set(widest * widest) * squared;
        const FloatMask is_near = hn::Or(wide, length > set(longest * longest) * squared);
        // A quarter may be a fifth nearer than the middle, and three quarters wider by its taper.
        const FloatMask wide_quarter = width > set(0.2f * widest * widest) * squared;
        const FloatMask long_quarter = length > set(quartered * quartered) * squared;
        const FloatMask is_piece = hn::Or(wide, hn::And(is_near, hn::Or(wide_quarter, long_quarter)));
        splat_segments(igloo, from, v, is_near, to.size + i, to);
        uint8_t bits[2][8] = {};
        hn::StoreMaskBits(d, hn::AndNot(is_piece, is_near), bits[0]);
        hn::StoreMaskBits(d, is_piece, bits[1]);
        near.quartered |= uint32_t(bits[0][0] | bits[0][1] << 8) << i;
        near.pieces |= uint32_t(bits[1][0] | bits[1][1] << 8) << i;
    }
    return near;
}

/// Row `i` of `s`, to be quartered.
inline void add_row(const ProjectedSegments& s, size_t i, uint32_t kind, QuarteredSegments& to) {
    const size_t at = to.size++;
    to.rows.x[at] = s.x[i], to.rows.y[at] = s.y[i], to.rows.z[at] = s.z[i];
    to.rows.ux[at] = s.ux[i], to.rows.uy[at] = s.uy[i], to.rows.uz[at] = s.uz[i];
    to.rows.length[at] = s.length[i], to.rows.radius[at] = s.radius[i], to.rows.taper[at] = s.taper[i];
    to.kind[at] = int32_t(kind);
}

/// Four splats for each of the segments, whose list is emptied.
template <class Depth>
void draw_quarters(const Igloo& igloo, const Viewpoint& from, const HairOpacity& opacity, ProjectionScratch& scratch,
                   CellDepths<Depth>& to) {
    const Floats d;
    const Ints di;
    QuarteredSegments& q = scratch.quartered;
    if (q.size == 0) return;
    for (size_t i = q.size; i < kMostLanes; ++i) q.rows.length[i] = q.rows.radius[i] = 0;
    CellSplats& splats = scratch.segment_splats;
    for (const float place : {-0.75f, -0.25f, 0.25f, 0.75f}) {  // of the middle of a quarter, in halves of the segment
        if (!splats.has_room(kMostLanes)) add_to_cells(opacity, splats, to);
        for (size_t i = 0; i < kMostLanes; i += hn::Lanes(d)) {
            const size_t at = splats.size + i;
            splat_segments(igloo, from, look_at(q.rows, i, from, place, 0.25f), hn::FirstN(d, 0), at, splats);
            const IntVec first_row = hn::Load(di, &q.kind[i]) * hn::Set(di, kOpacityRows);
            hn::StoreU(hn::LoadU(di, &splats.opacity_row[at]) + first_row, di, &splats.opacity_row[at]);
        }
        splats.size += kMostLanes;
    }
    q.size = 0;
}

/// Row `i` of `s` as a piece to be drawn exactly.
inline void add_piece(const ProjectedSegments& s, const Viewpoint& from, size_t i, uint32_t kind, uint32_t segment,
                      PieceList& to) {
    const Vec3 middle = Vec3(s.x[i], s.y[i], s.z[i]) - from.position;
    const Vec3 half = 0.5f * s.length[i] * Vec3(s.ux[i], s.uy[i], s.uz[i]);
    to.add(middle - half, middle + half, s.radius[i] - s.taper[i], s.radius[i] + s.taper[i], 0, kind, segment);
}

/// Splats for kMostLanes rows of `s` from `first` on: as many at once whatever the vectors hold, so that sums are the
/// same on every instruction set. original_of(i) is the scene's segment of row first + i; those from `count` on are
/// padding.
template <class Depth, class Original>
HWY_INLINE void project_rows(const ProjectionInput& in, const Viewpoint& from, const Unseen& unseen,
                             const ProjectedSegments& s, size_t first, size_t count, const Original& original_of,
                             ProjectionScratch& scratch, CellDepths<Depth>& to) {
    CellSplats& splats = scratch.segment_splats;
    if (!splats.has_room(kMostLanes)) add_to_cells(in.opacity, splats, to);
    const size_t at = splats.size;
    const NearSegments near = splat_rows(in.igloo, s, first, from, splats);
    splats.size += count;
    if (!in.opacity.kind.empty())
        for (size_t i = 0; i < count; ++i)
            splats.opacity_row[at + i] += int32_t(in.opacity.kind[original_of(i)]) * kOpacityRows;
    const uint32_t all = (1u << count) - 1;
    for (uint32_t bits = near.quartered & all; bits != 0; bits &= bits - 1) {
        const size_t i = size_t(std::countr_zero(bits));
        const uint32_t original = original_of(i);
        if (unseen.holds(original, in.segments.stands_for)) continue;
        add_row(s, first + i, in.opacity.kind_of(original), scratch.quartered);
        if (scratch.quartered.size == kMostLanes) draw_quarters(in.igloo, from, in.opacity, scratch, to);
    }
    for (uint32_t bits = near.pieces & all; bits != 0; bits &= bits - 1) {
        const size_t i = size_t(std::countr_zero(bits));
        const uint32_t original = original_of(i);
        if (unseen.holds(original, in.segments.stands_for)) continue;
        if (scratch.pieces.full()) draw_pieces(in.igloo, from, in.opacity, scratch, to);
        add_piece(s, from, first + i, in.opacity.kind_of(original), original, scratch.pieces);
    }
}

/// Draws what is left of a point's segments.
template <class Depth>
void finish_rows(const ProjectionInput& in, const Viewpoint& from, ProjectionScratch& scratch, CellDepths<Depth>& to) {
    draw_quarters(in.igloo, from, in.opacity, scratch, to);
    add_to_cells(in.opacity, scratch.segment_splats, to);
    finish_pieces(in.igloo, from, in.opacity, scratch, to);
}

template <class Depth>
void project_segments(const ProjectionInput& in, const Viewpoint& from, const Unseen& unseen,
                      ProjectionScratch& scratch, CellDepths<Depth>& to) {
    const ProjectedSegments& s = in.segments;
    for (size_t i = 0; i < s.rows(); i += kMostLanes) {
        // Rows past the last segment have neither length nor radius; what is said of them does not count.
        const auto original_of = [&](size_t lane) {
            return s.original_of(std::min(s.segment_of(i + lane), s.segments - 1));
        };
        project_rows(in, from, unseen, s, i, kMostLanes, original_of, scratch, to);
    }
    finish_rows(in, from, scratch, to);
}

/// Those of scratch.chosen, as wide as their weights say.
template <class Depth>
void project_chosen(const ProjectionInput& in, const Viewpoint& from, const Unseen& unseen, ProjectionScratch& scratch,
                    CellDepths<Depth>& to) {
    const ProjectedSegments& all = in.segments;
    ProjectedSegments& block = scratch.chosen_rows;
    const std::vector<ChosenSegment>& chosen = scratch.chosen;
    for (size_t i = 0; i < chosen.size(); i += kMostLanes) {
        const size_t count = std::min(kMostLanes, chosen.size() - i);
        for (size_t lane = 0; lane < count; ++lane) {
            const size_t row = all.row_of(chosen[i + lane].segment);
            const float weight = chosen[i + lane].weight;
            block.x[lane] = all.x[row], block.y[lane] = all.y[row], block.z[lane] = all.z[row];
            block.ux[lane] = all.ux[row], block.uy[lane] = all.uy[row], block.uz[lane] = all.uz[row];
            block.length[lane] = all.length[row];
            block.radius[lane] = weight * all.radius[row], block.taper[lane] = weight * all.taper[row];
        }
        project_rows(
            in, from, unseen, block, 0, count, [&](size_t lane) { return chosen[i + lane].segment; }, scratch, to);
    }
    finish_rows(in, from, scratch, to);
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
