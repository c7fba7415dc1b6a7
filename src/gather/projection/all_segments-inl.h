// SPDX-License-Identifier: MIT
// Every segment projected: one splat for those that are small from the point, two or four for those that are not much
// longer, exact arcs for the rest.
#if defined(TRESS_GATHER_PROJECTION_ALL_SEGMENTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_GATHER_PROJECTION_ALL_SEGMENTS_INL_H
#undef TRESS_GATHER_PROJECTION_ALL_SEGMENTS_INL_H
#else
#define TRESS_GATHER_PROJECTION_ALL_SEGMENTS_INL_H
#endif

#include <bit>

#include "gather/projection/arcs-inl.h"
#include "gather/projection/projection_kernels.h"
#include "hwy/cache_control.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

/// The largest segments that splats stand for, in distances from the point. A point's own fiber, which reaches
/// kOwnStrandRadii along the strand, is longer or wider from it in any case, so that leaving it out is left to what is
/// not one splat.
struct SplatBounds {
    float longest;    // segment that is one splat; longer ones than a cell are cut up
    float halved;     // longest of two splats
    float quartered;  // longest of four, whose quarters are nearly as far away as its middle
    float widest;

    explicit SplatBounds(float cell_size)
        : longest(std::min(cell_size, 0.25f)),
          halved(std::min(2 * longest, 0.35f)),
          quartered(std::min(4 * longest, 0.5f)),
          widest(std::min(kWideShare * cell_size, 0.1f)) {}
};

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

/// Segments too near for one splat, by a bit each: those of which two or four parts are splats, and those that are not.
struct NearSegments {
    uint32_t halved = 0, quartered = 0, pieces = 0;
};

/// kMostLanes rows of `s` from `first` on as splats past the last of `to`, but for those too near.
HWY_INLINE NearSegments splat_rows(const Igloo& igloo, const SplatBounds& bounds, const ProjectedSegments& s,
                                   size_t first, const Viewpoint& from, CellSplats& to) {
    const Floats d;
    NearSegments near;
    for (size_t i = 0; i < kMostLanes; i += hn::Lanes(d)) {
        const SeenSegments v = look_at(s, first + i, from);
        const FloatVec squared = v.middle.squared, length = v.length * v.length,
                       width = set(4.0f) * v.radius * v.radius;
        const auto longer = [&](float than) { return length > set(than * than) * squared; };
        const FloatMask wide = width > set(square(bounds.widest)) * squared;
        const FloatMask is_near = hn::Or(wide, longer(bounds.longest));
        // A part may be a fifth nearer than the middle, and three quarters wider by its taper.
        const FloatMask wide_part = width > set(0.2f * square(bounds.widest)) * squared;
        const FloatMask is_piece = hn::Or(wide, hn::And(is_near, hn::Or(wide_part, longer(bounds.quartered))));
        const FloatMask is_parted = hn::AndNot(is_piece, is_near), is_long = longer(bounds.halved);
        splat_segments(igloo, from, v, is_near, to.size + i, to);
        near.halved |= bits_of(hn::AndNot(is_long, is_parted)) << i;
        near.quartered |= bits_of(hn::And(is_long, is_parted)) << i;
        near.pieces |= bits_of(is_piece) << i;
    }
    return near;
}

/// Row `i` of `s`.
inline void add_row(const ProjectedSegments& s, size_t i, uint32_t kind, PartedSegments& to) {
    const size_t at = to.size++;
    to.rows.x[at] = s.x[i], to.rows.y[at] = s.y[i], to.rows.z[at] = s.z[i];
    to.rows.ux[at] = s.ux[i], to.rows.uy[at] = s.uy[i], to.rows.uz[at] = s.uz[i];
    to.rows.length[at] = s.length[i], to.rows.radius[at] = s.radius[i], to.rows.taper[at] = s.taper[i];
    to.kind[at] = int32_t(kind);
}

/// A splat for each of kParts parts of the segments, whose list is emptied.
template <int kParts, class Depth>
void draw_parts(const Igloo& igloo, const Viewpoint& from, const HairOpacity& opacity, PartedSegments& segments,
                CellSplats& splats, CellDepths<Depth>& to) {
    const Floats d;
    const Ints di;
    if (segments.size == 0) return;
    ProjectedSegments& rows = segments.rows;
    for (size_t i = segments.size; i < kMostLanes; ++i) rows.length[i] = rows.radius[i] = 0;
    for (int part = 0; part < kParts; ++part) {
        const float place = float(2 * part + 1) / kParts - 1;  // of its middle, in halves of the segment
        if (!splats.has_room(kMostLanes)) add_to_cells(opacity, splats, to);
        for (size_t i = 0; i < kMostLanes; i += hn::Lanes(d)) {
            const size_t at = splats.size + i;
            splat_segments(igloo, from, look_at(rows, i, from, place, 1.0f / kParts), hn::FirstN(d, 0), at, splats);
            const IntVec first_row = hn::Load(di, &segments.kind[i]) * hn::Set(di, kOpacityRows);
            hn::StoreU(hn::LoadU(di, &splats.opacity_row[at]) + first_row, di, &splats.opacity_row[at]);
        }
        splats.size += kMostLanes;
    }
    segments.size = 0;
}

/// Draws and empties the lists of segments in parts, those that have `at_least` so many.
template <class Depth>
void draw_parted(const ProjectionInput& in, const Viewpoint& from, size_t at_least, ProjectionScratch& scratch,
                 CellDepths<Depth>& to) {
    if (scratch.halved.size >= at_least)
        draw_parts<2>(in.igloo, from, in.opacity, scratch.halved, scratch.segment_splats, to);
    if (scratch.quartered.size >= at_least)
        draw_parts<4>(in.igloo, from, in.opacity, scratch.quartered, scratch.segment_splats, to);
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
HWY_INLINE void project_rows(const ProjectionInput& in, const SplatBounds& bounds, const Viewpoint& from,
                             const Unseen& unseen, const ProjectedSegments& s, size_t first, size_t count,
                             const Original& original_of, ProjectionScratch& scratch, CellDepths<Depth>& to) {
    CellSplats& splats = scratch.segment_splats;
    if (!splats.has_room(kMostLanes)) add_to_cells(in.opacity, splats, to);
    const size_t at = splats.size;
    const NearSegments near = splat_rows(in.igloo, bounds, s, first, from, splats);
    splats.size += count;
    if (!in.opacity.kind.empty())
        for (size_t i = 0; i < count; ++i)
            splats.opacity_row[at + i] += int32_t(in.opacity.kind[original_of(i)]) * kOpacityRows;
    const uint32_t all = (1u << count) - 1;
    for (uint32_t bits = (near.halved | near.quartered) & all; bits != 0; bits &= bits - 1) {
        const size_t i = size_t(std::countr_zero(bits));
        const uint32_t original = original_of(i);
        if (unseen.holds(original, in.segments.stands_for)) continue;
        PartedSegments& parted = near.halved >> i & 1 ? scratch.halved : scratch.quartered;
        add_row(s, first + i, in.opacity.kind_of(original), parted);
        if (parted.size == kMostLanes) draw_parted(in, from, kMostLanes, scratch, to);
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
    draw_parted(in, from, 1, scratch, to);
    add_to_cells(in.opacity, scratch.segment_splats, to);
    finish_pieces(in.igloo, from, in.opacity, scratch, to);
}

template <class Depth>
void project_segments(const ProjectionInput& in, const Viewpoint& from, const Unseen& unseen,
                      ProjectionScratch& scratch, CellDepths<Depth>& to) {
    const ProjectedSegments& s = in.segments;
    if (s.rows() == 0) return;
    const SplatBounds bounds(in.igloo.cell_size());
    constexpr size_t kAhead = 16 * kMostLanes;
    const size_t last = s.rows() - 1;
    for (size_t i = 0; i < s.rows(); i += kMostLanes) {
        // Rows past the last segment have neither length nor radius; what is said of them does not count.
        const auto original_of = [&](size_t lane) {
            return s.original_of(std::min(s.segment_of(i + lane), s.segments - 1));
        };
        hwy::Prefetch(&s.taper[std::min(i + kAhead, last)]);  // near rows alone read it: cold in any cache
        project_rows(in, bounds, from, unseen, s, i, kMostLanes, original_of, scratch, to);
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
    const SplatBounds bounds(in.igloo.cell_size());
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
            in, bounds, from, unseen, block, 0, count, [&](size_t lane) { return chosen[i + lane].segment; }, scratch,
            to);
    }
    finish_rows(in, from, scratch, to);
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
