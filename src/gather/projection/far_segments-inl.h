// SPDX-License-Identifier: MIT
// Every segment projected: one splat for those that are small from the point, exact arcs for the rest.
#if defined(TRESS_GATHER_PROJECTION_FAR_SEGMENTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_GATHER_PROJECTION_FAR_SEGMENTS_INL_H
#undef TRESS_GATHER_PROJECTION_FAR_SEGMENTS_INL_H
#else
#define TRESS_GATHER_PROJECTION_FAR_SEGMENTS_INL_H
#endif

#include <bit>

#include "gather/projection/arcs-inl.h"
#include "gather/projection/projection_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

/// One splat stands for a segment of at most this length, in distances; longer ones than a cell are cut up.
HWY_INLINE float longest_splat(float cell_size) { return std::min(cell_size, 0.25f); }

/// Nor for one that looks wider. A point's own fiber, which reaches kOwnStrandRadii along the strand, is longer or wider
/// than this from it in any case, so that leaving it out is left to the pieces drawn exactly.
HWY_INLINE float widest_splat(float cell_size) { return std::min(kWideShare * cell_size, 0.1f); }

/// A vector of segments as one splat each: solid angle 2 r L sin(alpha) / d^2 (1 + (5 g^2 - L^2) / (8 d^2)), with alpha
/// the angle between tangent and direction and g = L cos(alpha): the integral over the axis up to the fourth power of
/// L / d. Returns those that are too near; their solid angle is set to 0.
HWY_INLINE FloatMask splat_segments(const ProjectedSegments& s, size_t i, const Viewpoint& from, float longest,
                                    float widest, float weight, Splats& to) {
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
    const FloatVec solid = set(2 * weight) * radius * length * sine_alpha * inverse_squared * higher;
    const FloatVec width = set(2 * weight) * radius;
    const FloatMask near = hn::Or(length * length > set(longest * longest) * squared,
                                  width * width > set(widest * widest) * squared);
    hn::StoreU(x, d, &to.x[to.size]), hn::StoreU(y, d, &to.y[to.size]), hn::StoreU(z, d, &to.z[to.size]);
    hn::StoreU(hn::IfThenZeroElse(near, solid), d, &to.solid_angle[to.size]);
    const FloatVec row = sine_alpha * set(float(kOpacityRows - 1)) + set(0.5f);
    hn::StoreU(hn::ConvertTo(di, row), di, &to.opacity_row[to.size]);
    return near;
}

/// Row `i` of the segments as a piece to be drawn exactly.
inline void add_piece(const ProjectionInput& in, const Viewpoint& from, size_t i, uint32_t segment, PieceList& to) {
    const ProjectedSegments& s = in.segments;
    const Vec3 middle = Vec3(s.x[i], s.y[i], s.z[i]) - from.position;
    const Vec3 half = 0.5f * s.length[i] * Vec3(s.ux[i], s.uy[i], s.uz[i]);
    const float radius = in.weight * s.radius[i], taper = in.weight * s.taper[i];
    to.add(middle - half, middle + half, radius - taper, radius + taper, in.opacity.kind_of(segment));
}

template <class Depth>
void project_segments(const ProjectionInput& in, const Viewpoint& from, const Unseen& unseen,
                      ProjectionScratch& scratch, CellDepths<Depth>& to) {
    const size_t lanes = hn::Lanes(Floats());
    const float cell_size = in.igloo.cell_size();
    const float longest = longest_splat(cell_size), widest = widest_splat(cell_size);
    const ProjectedSegments& segments = in.segments;
    Splats& splats = scratch.splats;
    for (size_t i = 0; i < segments.rows(); i += lanes) {
        if (!splats.has_room(lanes)) add_splats(in.igloo, from, in.opacity, splats, to);
        const FloatMask near_lanes = splat_segments(segments, i, from, longest, widest, in.weight, splats);
        if (!in.opacity.kind.empty())
            for (size_t lane = 0; lane < lanes; ++lane) {
                const size_t segment = std::min(segments.segment_of(i + lane), segments.segments - 1);
                splats.opacity_row[splats.size + lane] += int32_t(in.opacity.kind[segment]) * kOpacityRows;
            }
        splats.size += lanes;
        uint8_t bits[8] = {};
        hn::StoreMaskBits(Floats(), near_lanes, bits);
        for (uint32_t near = uint32_t(bits[0] | bits[1] << 8); near != 0; near &= near - 1) {
            const size_t row = i + size_t(std::countr_zero(near)), segment = segments.segment_of(row);
            if (segment >= segments.segments || unseen.holds(uint32_t(segment))) continue;
            if (scratch.pieces.full()) draw_pieces(in.igloo, from, in.opacity, scratch, to);
            add_piece(in, from, row, uint32_t(segment), scratch.pieces);
        }
    }
    draw_pieces(in.igloo, from, in.opacity, scratch, to);
    add_splats(in.igloo, from, in.opacity, splats, to);
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
