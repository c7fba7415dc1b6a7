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
HWY_INLINE float longest_splat(float cell_size) { return std::min(kArcStep * cell_size, 0.25f); }

/// A vector of segments as one splat each: solid angle 2 r L sin(alpha) / d^2 (1 + (5 g^2 - L^2) / (8 d^2)), with alpha
/// the angle between tangent and direction and g = L cos(alpha): the integral over the axis up to the fourth power of
/// L / d. Returns those that are too near; their solid angle is set to 0.
HWY_INLINE FloatMask splat_segments(const ProjectedSegments& s, size_t i, const Viewpoint& from, float longest,
                                    float widest, float weight, Splats& to) {
    const Floats d;
    const Ints di;
    const FloatVec one = set(1.0f);
    const FloatVec x = hn::LoadU(d, &s.x[i]) - set(from.position.x), y = hn::LoadU(d, &s.y[i]) - set(from.position.y),
                   z = hn::LoadU(d, &s.z[i]) - set(from.position.z);
    const FloatVec length = hn::LoadU(d, &s.length[i]), radius = hn::LoadU(d, &s.radius[i]);
    const FloatVec squared = hn::Max(dot3(x, y, z, x, y, z), set(1e-30f));
    const FloatVec inverse = inverse_sqrt(squared), inverse_squared = inverse * inverse;
    const FloatVec along = dot3(x, y, z, hn::LoadU(d, &s.ux[i]), hn::LoadU(d, &s.uy[i]), hn::LoadU(d, &s.uz[i]));
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

template <class Depth>
void project_range(const ProjectionInput& in, const Viewpoint& from, size_t first, size_t end,
                   ProjectionScratch& scratch, CellDepths<Depth>& to) {
    const Floats d;
    const size_t lanes = hn::Lanes(d);
    const float cell_size = in.igloo.cell_size();
    const float longest = longest_splat(cell_size), widest = kWideShare * cell_size;
    Splats& splats = scratch.splats;
    for (size_t i = first; i < end; i += lanes) {
        if (!splats.has_room(lanes)) add_splats(in.igloo, from, in.opacity, splats, to);
        const size_t count = std::min(lanes, end - i);
        uint8_t bits[8] = {};
        hn::StoreMaskBits(d, splat_segments(in.segments, i, from, longest, widest, in.weight, splats), bits);
        for (uint32_t near = uint32_t(bits[0] | bits[1] << 8) & ((1u << count) - 1); near != 0; near &= near - 1)
            scratch.near_segments.push_back(uint32_t(i) + uint32_t(std::countr_zero(near)));
        if (!in.opacity.kind.empty())
            for (size_t lane = 0; lane < count; ++lane)
                splats.opacity_row[splats.size + lane] += int32_t(in.opacity.kind[i + lane]) * kOpacityRows;
        splats.size += count;
    }
}

template <class Depth>
void draw_near_segments(const ProjectionInput& in, const Viewpoint& from, ProjectionScratch& scratch,
                        CellDepths<Depth>& to) {
    for (const uint32_t i : scratch.near_segments) {
        if (scratch.pieces.full()) draw_pieces(in.igloo, from, in.opacity, scratch, to);
        scratch.pieces.add(in.view.start(i) - from.position, in.view.end(i) - from.position,
                           in.weight * in.view.start_radius(i), in.weight * in.view.end_radius(i),
                           in.opacity.kind_of(i));
    }
    scratch.near_segments.clear();
    draw_pieces(in.igloo, from, in.opacity, scratch, to);
}

template <class Depth>
void project_segments(const ProjectionInput& in, const Viewpoint& from, const Unseen& unseen,
                      ProjectionScratch& scratch, CellDepths<Depth>& to) {
    const size_t all = in.segments.size;
    if (unseen.first > unseen.last) {
        project_range(in, from, 0, all, scratch, to);
    } else {
        project_range(in, from, 0, std::min(size_t(unseen.first), all), scratch, to);
        project_range(in, from, std::min(size_t(unseen.last) + 1, all), all, scratch, to);
    }
    draw_near_segments(in, from, scratch, to);
    add_splats(in.igloo, from, in.opacity, scratch.splats, to);
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
