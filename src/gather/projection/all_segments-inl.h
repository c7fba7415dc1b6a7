// SPDX-License-Identifier: MIT
// Every segment projected: one splat for those that are small from the point, exact arcs for the rest.
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

/// Nor for one that looks wider. A point's own fiber, which reaches kOwnStrandRadii along the strand, is longer or
/// wider than this from it in any case, so that leaving it out is left to the pieces drawn exactly.
HWY_INLINE float widest_splat(float cell_size) { return std::min(kWideShare * cell_size, 0.1f); }

/// A vector of segments as one splat each, at rows `at` and on: solid angle 2 r L sin(alpha) / d^2 (1 + (5 g^2 - L^2) /
/// (8 d^2)), with alpha the angle between tangent and direction and g = L cos(alpha): the integral over the axis up to
/// the fourth power of L / d. Returns those that are too near; their solid angle is set to 0.
HWY_INLINE FloatMask splat_segments(const ProjectedSegments& s, size_t i, const Viewpoint& from, float longest,
                                    float widest, size_t at, Splats& to) {
    const Floats d;
    const Ints di;
    const FloatVec one = set(1.0f);
    const FloatVec x = hn::Load(d, &s.x[i]) - set(from.position.x), y = hn::Load(d, &s.y[i]) - set(from.position.y),
                   z = hn::Load(d, &s.z[i]) - set(from.position.z);
    const FloatVec length = hn::Load(d, &s.length[i]), radius = hn::Load(d, &s.radius[i]);
    const FloatVec squared = hn::Max(dot3(x, y, z, x, y, z), set(1e-30f));
    const FloatVec inverse = inverse_sqrt(squared), inverse_squared = inverse * inverse;
    const FloatVec along = dot3(x, y, z, hn::Load(d, &s.ux[i]), hn::Load(d, &s.uy[i]), hn::Load(d, &s.uz[i]));
    const FloatVec cosine = along * inverse;
    const FloatVec sine_squared = hn::Max(one - cosine * cosine, set(1e-12f));
    const FloatVec sine_alpha = sine_squared * inverse_sqrt(sine_squared);
    const FloatVec in_distances = length * length * inverse_squared;
    const FloatVec higher = one + set(0.125f) * in_distances * (set(5.0f) * cosine * cosine - one);
    const FloatVec solid = set(2.0f) * radius * length * sine_alpha * inverse_squared * higher;
    const FloatVec width = set(2.0f) * radius;
    const FloatMask near =
        hn::Or(length * length > set(longest * longest) * squared, width * width > set(widest * widest) * squared);
    hn::StoreU(x, d, &to.x[at]), hn::StoreU(y, d, &to.y[at]), hn::StoreU(z, d, &to.z[at]);
    hn::StoreU(hn::IfThenZeroElse(near, solid), d, &to.solid_angle[at]);
    const FloatVec row = sine_alpha * set(float(kOpacityRows - 1)) + set(0.5f);
    hn::StoreU(hn::ConvertTo(di, row), di, &to.opacity_row[at]);
    return near;
}

/// Row `i` of `s` as a piece to be drawn exactly.
inline void add_piece(const ProjectedSegments& s, const Viewpoint& from, size_t i, uint32_t kind, uint32_t segment,
                      PieceList& to) {
    const Vec3 middle = Vec3(s.x[i], s.y[i], s.z[i]) - from.position;
    const Vec3 half = 0.5f * s.length[i] * Vec3(s.ux[i], s.uy[i], s.uz[i]);
    to.add(middle - half, middle + half, s.radius[i] - s.taper[i], s.radius[i] + s.taper[i], kind, segment);
}

/// Splats for kMostLanes rows of `s` from `first` on: as many at once whatever the vectors hold, so that sums are the
/// same on every instruction set. original_of(i) is the scene's segment of row first + i; those from `count` on are
/// padding.
template <class Depth, class Original>
HWY_INLINE void project_rows(const ProjectionInput& in, const Viewpoint& from, const Unseen& unseen,
                             const ProjectedSegments& s, size_t first, size_t count, const Original& original_of,
                             ProjectionScratch& scratch, CellDepths<Depth>& to) {
    const float cell_size = in.igloo.cell_size();
    const float longest = longest_splat(cell_size), widest = widest_splat(cell_size);
    Splats& splats = scratch.splats;
    if (!splats.has_room(kMostLanes)) add_splats(in.igloo, from, in.opacity, splats, to);
    uint32_t near = 0;
    for (size_t i = 0; i < kMostLanes; i += hn::Lanes(Floats())) {
        uint8_t bits[8] = {};
        hn::StoreMaskBits(Floats(), splat_segments(s, first + i, from, longest, widest, splats.size + i, splats), bits);
        near |= uint32_t(bits[0] | bits[1] << 8) << i;
    }
    if (!in.opacity.kind.empty())
        for (size_t i = 0; i < count; ++i)
            splats.opacity_row[splats.size + i] += int32_t(in.opacity.kind[original_of(i)]) * kOpacityRows;
    splats.size += count;
    for (near &= (1u << count) - 1; near != 0; near &= near - 1) {
        const size_t i = size_t(std::countr_zero(near));
        const uint32_t original = original_of(i);
        if (unseen.holds(original, in.segments.stands_for)) continue;
        if (scratch.pieces.full()) draw_pieces(in.igloo, from, in.opacity, scratch, to);
        add_piece(s, from, first + i, in.opacity.kind_of(original), original, scratch.pieces);
    }
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
    finish_pieces(in.igloo, from, in.opacity, scratch, to);
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
    finish_pieces(in.igloo, from, in.opacity, scratch, to);
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
