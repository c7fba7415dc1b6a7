// SPDX-License-Identifier: MIT
// Pieces of hair that are wide in a cell: of each cell that one may cover, the squares about its samples are asked how
// much of them lies within the piece's edges.
#if defined(TRESS_GATHER_PROJECTION_WIDE_FIBER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_GATHER_PROJECTION_WIDE_FIBER_INL_H
#undef TRESS_GATHER_PROJECTION_WIDE_FIBER_INL_H
#else
#define TRESS_GATHER_PROJECTION_WIDE_FIBER_INL_H
#endif

#include <algorithm>
#include <bit>
#include <cmath>

#include "gather/projection/near_fiber-inl.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

/// A piece in the frame of an igloo. With u along its axis, n towards the foot of the perpendicular and b across both,
/// a ray along w passes the axis at the distance foot (w b) / q and at the place foot (w n) (w u) / q^2 along it, where
/// q^2 = (w n)^2 + (w b)^2.
struct WidePiece {
    Vec3 u, n, b;
    float foot, first, last;    // of the axis' places
    float first_radius, taper;  // change of radius along the axis
    float widest, mean_radius;
    float around;                   // angle from a cell's middle to the farthest direction in it
    float least_along, most_along;  // w u of directions within `around` of one that meets the piece lies between

    WidePiece(const ArcRow& arc, const Frame& frame, float cell_radius)
        : u(frame.to_local(arc.axis)),
          n(frame.to_local(arc.normal)),
          b(cross(u, n)),
          foot(arc.foot),
          first(arc.along),
          last(arc.along + arc.length),
          first_radius(arc.radius * (1 - 0.5f * arc.taper * arc.length)),
          taper(arc.radius * arc.taper),
          widest(std::max(first_radius, 2 * arc.radius - first_radius)),
          mean_radius(arc.radius),
          around(cell_radius) {
        // The feet of rays beside the axis' middle are nearer than its own.
        const float sine = std::min(widest / foot, 1.0f), nearest = foot * safe_sqrt(1 - sine * sine);
        const float cos_around = std::cos(around), sin_around = std::sin(around);
        const auto moved = [&](float place, float of_foot, float way) {  // sine of the inclination, `around` further
            const float far = std::max(std::sqrt(place * place + of_foot * of_foot), 1e-30f);
            const float inclination = place / far;
            return way * inclination > cos_around ? way : inclination * cos_around + way * of_foot / far * sin_around;
        };
        least_along = moved(first, first < 0 ? nearest : foot, -1);
        most_along = moved(last, last > 0 ? nearest : foot, 1);
    }
};

/// The piece's solid angle: the integral of place / distance, last less first, over angles about the axis; and of the
/// change of its width along the axis. By Gauss' rules of three points.
inline float solid_angle(const WidePiece& p) {
    constexpr float kNode = 0.7745967f;
    const auto width = [&](float radius) { return 2 * std::asin(std::min(radius / p.foot, 1.0f)); };
    const auto sine = [](float place, float foot) { return place / std::sqrt(place * place + foot * foot); };
    const float whole = width(p.mean_radius);
    const auto span = [&](float angle) {
        const float foot = p.foot * std::cos(angle);
        return sine(p.last, foot) - sine(p.first, foot);
    };
    const float even = whole * (8 * span(0) + 10 * span(kNode * 0.5f * whole)) / 18;
    if (p.taper == 0) return even;
    const float from = sine(p.first, p.foot), to = sine(p.last, p.foot);
    const auto width_at = [&](float node) {
        const float along = 0.5f * (from + to) + 0.5f * node * (to - from);
        const float place = p.foot * along / std::sqrt(std::max(1 - along * along, 1e-12f));
        return width(p.first_radius + p.taper * (std::clamp(place, p.first, p.last) - p.first));
    };
    return even * (5 * width_at(-kNode) + 8 * width_at(0) + 5 * width_at(kNode)) / (18 * whole);
}

/// Unit direction of the middle of the piece's axis.
inline Vec3 middle_of(const WidePiece& p) {
    const Vec3 middle = p.foot * p.n + 0.5f * (p.first + p.last) * p.u;
    const float far = length(middle);
    return far > 0 ? middle / far : p.n;
}

/// Of a vector of directions, which may be within `around` of one that meets the piece.
HWY_INLINE FloatMask near_piece(const WidePiece& p, const Directions& w) {
    const FloatVec along = w.along(p.u), ahead = w.along(p.n), aside = w.along(p.b);
    const FloatVec q = hn::Sqrt(ahead * ahead + aside * aside), around = set(p.around);
    const FloatMask beside = set(p.foot) * (hn::Abs(aside) - around) <= set(p.widest) * (q + around);
    const FloatMask within = hn::And(along >= set(p.least_along), along <= set(p.most_along));
    return hn::And(hn::And(beside, within), ahead >= hn::Neg(around));
}

/// How much of a square is within an edge, from the sine of the angle of its middle to it, positive within: exact where
/// its sides, of which `to_radian` make a radian, are along the edge.
HWY_INLINE FloatVec share_within(FloatVec edge, FloatVec to_radian) {
    return hn::Clamp(set(0.5f) + edge * to_radian, hn::Zero(Floats()), set(1.0f));
}
/// The same between two edges that face each other.
HWY_INLINE FloatVec share_between(FloatVec within_one, FloatVec within_other) {
    return hn::Max(within_one + within_other - set(1.0f), hn::Zero(Floats()));
}

/// Of a vector of samples: whether the piece covers them, and how much of the squares about them.
struct CoveredSquares {
    FloatMask sample;
    FloatVec share;
};

HWY_INLINE CoveredSquares covered_squares(const WidePiece& p, const Directions& w, FloatVec to_radian) {
    const FloatVec zero = hn::Zero(Floats()), one = set(1.0f), first = set(p.first), last = set(p.last);
    const FloatVec along = w.along(p.u), ahead = w.along(p.n), aside = w.along(p.b);
    const FloatVec q = hn::Sqrt(hn::Max(ahead * ahead + aside * aside, set(1e-12f)));
    const FloatVec near = set(p.foot) * hn::Max(ahead, zero) / q;  // distance of the axis there
    const FloatVec place = hn::Clamp(near * along / q, first, last);
    // The half planes through the axis that bound it, and the planes across of its ends.
    const FloatVec sine = hn::Min((set(p.first_radius) + set(p.taper) * (place - first)) / set(p.foot), one);
    const FloatVec cosine = hn::Sqrt(one - sine * sine);
    const FloatVec left = sine * ahead - cosine * aside, right = sine * ahead + cosine * aside;
    const auto past = [&](FloatVec end) {
        return (along * near - q * end) / hn::Sqrt(hn::Max(end * end + near * near, set(1e-30f)));
    };
    const FloatVec past_first = past(first), before_last = hn::Neg(past(last));
    const FloatMask sample =
        hn::And(hn::Min(left, right) >= zero, hn::And(hn::Min(past_first, before_last) >= zero, ahead > zero));
    // The half planes of a piece next to its point are nearly one.
    const FloatVec to_left = share_within(left, to_radian), to_right = share_within(right, to_radian);
    const FloatVec beside = hn::IfThenElse(sine > cosine, hn::Min(to_left, to_right), share_between(to_left, to_right));
    return {sample, beside * share_between(share_within(past_first, to_radian), share_within(before_last, to_radian))};
}

inline constexpr int32_t kSampleParts = 1 << 12;  // of a sample's square: whole numbers, whose sums have no order

/// What of a cell the piece covers.
HWY_INLINE CoveredSamples covered_samples(const Igloo& igloo, uint32_t cell, const WidePiece& piece) {
    const Floats d;
    const SampleRows rows = igloo.samples_of(cell);
    const FloatVec to_radian = set(float(Igloo::kSampleSide) / igloo.cell_size());
    CoveredSamples covered = {cell, 0, 0};
    IntVec parts = hn::Zero(Ints());
    for (size_t i = 0; i < Igloo::kSamples; i += hn::Lanes(d)) {
        const size_t column = i % Igloo::kColumnEntries;
        const FloatVec radius = hn::LoadU(d, rows.radius + i);
        const Directions sample = {radius * hn::LoadU(d, rows.cosine + column),
                                   radius * hn::LoadU(d, rows.sine + column),
                                   set(rows.up) * hn::LoadU(d, rows.height + i)};
        const CoveredSquares squares = covered_squares(piece, sample, to_radian);
        parts = parts + nearest_int(squares.share * set(float(kSampleParts)));
        covered.samples |= uint64_t(bits_of(squares.sample)) << i;
    }
    covered.parts = uint32_t(hn::GetLane(hn::SumOfLanes(Ints(), parts)));
    return covered;
}

/// Share of a cell that a part of a sample stands for: all those covered make up the piece's solid angle, but for one
/// so wide that samples say it better than three angles about its axis. With none, the piece is smaller than a part,
/// and this is its own share.
inline float share_of_part(const Igloo& igloo, const WidePiece& piece, uint64_t parts) {
    if (parts > 0 && piece.widest > 0.7f * piece.foot) return 1.0f / (kSampleParts * Igloo::kSamples);
    return solid_angle(piece) / (igloo.solid_angle() * float(std::max<uint64_t>(parts, 1)));
}

/// Adds a wide piece.
inline void cover_wide(const Igloo& igloo, const Viewpoint& from, const HairOpacity& opacity, const ArcRow& arc,
                       ProjectionScratch& scratch) {
    const WidePiece piece(arc, from.frame, igloo.cell_radius);
    const size_t cells = igloo.cells_of(from.dome);
    uint64_t parts = 0;
    auto& list = scratch.covered;
    list.clear();
    for_middles_between(igloo, heights_of(arc, piece.u.z, piece.n.z),
                        [&](uint32_t first, const Directions& middle, uint32_t end) {
                            uint32_t bits = cells_before(end, first, near_piece(piece, middle));
                            for (; bits != 0; bits &= bits - 1) {
                                const uint32_t cell = first + uint32_t(std::countr_zero(bits));
                                const CoveredSamples covered = covered_samples(igloo, cell, piece);
                                parts += covered.parts;
                                if (covered.parts > 0 && cell < cells) list.push_back(covered);
                            }
                        });
    if (parts == 0) {
        const uint32_t cell = cell_of(igloo, middle_of(piece));
        if (cell < cells) list.push_back({cell, 0, 1});
    }
    const float share = share_of_part(igloo, piece, parts);
    for (const CoveredSamples& seen : list)
        add_covered(from, cells, opacity, arc, piece.n, piece.b,
                    {center_of(igloo, seen.cell), seen.cell, share * float(seen.parts), seen.samples}, scratch.near);
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
