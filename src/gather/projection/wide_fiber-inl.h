// SPDX-License-Identifier: MIT
// Pieces of hair that are wide in a cell: of each cell that one may cover, the squares about its samples are asked how
// much of them lies within the piece's edges. What a fiber stops is summed over its pieces before it becomes depth:
// they cover a cell side by side, not one behind another.
#if defined(TRESS_GATHER_PROJECTION_WIDE_FIBER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_GATHER_PROJECTION_WIDE_FIBER_INL_H
#undef TRESS_GATHER_PROJECTION_WIDE_FIBER_INL_H
#else
#define TRESS_GATHER_PROJECTION_WIDE_FIBER_INL_H
#endif

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/sampling.h"
#include "gather/projection/igloo.h"
#include "gather/projection/projection_scratch.h"
#include "gather/projection/vector_math-inl.h"

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
HWY_INLINE FloatMask near_piece(const WidePiece& p, FloatVec x, FloatVec y, FloatVec z) {
    const FloatVec along = dot3(x, y, z, set(p.u.x), set(p.u.y), set(p.u.z));
    const FloatVec ahead = dot3(x, y, z, set(p.n.x), set(p.n.y), set(p.n.z));
    const FloatVec aside = dot3(x, y, z, set(p.b.x), set(p.b.y), set(p.b.z));
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

/// Of a vector of directions, how much of the squares about them the piece covers.
HWY_INLINE FloatVec covered_share(const WidePiece& p, FloatVec x, FloatVec y, FloatVec z, FloatVec to_radian) {
    const FloatVec one = set(1.0f), first = set(p.first), last = set(p.last), tiny = set(1e-30f);
    const FloatVec along = dot3(x, y, z, set(p.u.x), set(p.u.y), set(p.u.z));
    const FloatVec ahead = dot3(x, y, z, set(p.n.x), set(p.n.y), set(p.n.z));
    const FloatVec aside = dot3(x, y, z, set(p.b.x), set(p.b.y), set(p.b.z));
    const FloatVec q = hn::Sqrt(hn::Max(ahead * ahead + aside * aside, set(1e-12f)));
    const FloatVec near = set(p.foot) * hn::Max(ahead, hn::Zero(Floats())) / q;  // distance of the axis there
    const FloatVec place = hn::Clamp(near * along / q, first, last);
    // The half planes through the axis that bound it, and the planes across of its ends.
    const FloatVec sine = hn::Min((set(p.first_radius) + set(p.taper) * (place - first)) / set(p.foot), one);
    const FloatVec cosine = hn::Sqrt(one - sine * sine);
    const FloatVec in_front = sine * ahead, to_side = cosine * aside;
    const auto beyond = [&](FloatVec end) {
        return (along * near - q * end) / hn::Sqrt(hn::Max(end * end + near * near, tiny));
    };
    // The half planes of a piece next to its point are nearly one.
    const FloatVec left = share_within(in_front - to_side, to_radian),
                   right = share_within(in_front + to_side, to_radian);
    const FloatVec beside = hn::IfThenElse(sine > cosine, hn::Min(left, right), share_between(left, right));
    return beside *
           share_between(share_within(beyond(first), to_radian), share_within(hn::Neg(beyond(last)), to_radian));
}

/// Calls on_cell(cell) for each of the first `cells` that may see the piece, in order.
template <class OnCell>
HWY_INLINE void for_cells_near(const Igloo& igloo, size_t cells, const WidePiece& piece, const OnCell& on_cell) {
    const Floats d;
    for (size_t first = 0; first < cells; first += hn::Lanes(d)) {
        const FloatMask near = near_piece(piece, hn::LoadU(d, &igloo.center_x[first]),
                                          hn::LoadU(d, &igloo.center_y[first]), hn::LoadU(d, &igloo.center_z[first]));
        for (uint32_t bits = bits_of(near); bits != 0; bits &= bits - 1) {
            const size_t cell = first + size_t(std::countr_zero(bits));
            if (cell < cells) on_cell(cell);
        }
    }
}

inline constexpr int32_t kSampleParts = 1 << 12;  // of a sample's square: whole numbers, whose sums have no order

/// How many parts of the squares about a cell's samples the piece covers.
HWY_INLINE uint32_t parts_covered(const Igloo& igloo, size_t cell, const WidePiece& piece) {
    const Floats d;
    const bool lower = cell >= igloo.cells;
    const size_t first = (lower ? cell - igloo.cells : cell) * Igloo::kSamples;
    const FloatVec up = set(lower ? -1.0f : 1.0f);
    const FloatVec to_radian = set(float(Igloo::kSampleSide) / igloo.cell_size());
    IntVec parts = hn::Zero(Ints());
    for (size_t i = first; i < first + Igloo::kSamples; i += hn::Lanes(d)) {
        const FloatVec share = covered_share(piece, hn::LoadU(d, &igloo.sample_x[i]), hn::LoadU(d, &igloo.sample_y[i]),
                                             up * hn::LoadU(d, &igloo.sample_z[i]), to_radian);
        parts = parts + nearest_int(share * set(float(kSampleParts)));
    }
    return uint32_t(hn::GetLane(hn::SumOfLanes(Ints(), parts)));
}

/// Share of a cell that a part of a sample stands for: all those covered make up the piece's solid angle, but for one
/// so wide that samples say it better than three angles about its axis. With none, the piece is smaller than a part,
/// and this is its own share.
inline float share_of_part(const Igloo& igloo, const WidePiece& piece, uint32_t parts) {
    if (parts > 0 && piece.widest > 0.7f * piece.foot) return 1.0f / (kSampleParts * Igloo::kSamples);
    return solid_angle(piece) / (igloo.solid_angle() * float(std::max(parts, 1u)));
}

/// Adds what the piece stops to the sums of its fiber.
inline void cover(const Igloo& igloo, const Viewpoint& from, const HairOpacity& opacity, const ArcRow& arc,
                  WideFiber& to) {
    const WidePiece piece(arc, from.frame, igloo.cell_radius);
    const size_t cells = igloo.cells_of(from.dome);
    uint32_t parts = 0;
    to.covered.clear();
    for_cells_near(igloo, 2 * igloo.cells, piece, [&](size_t cell) {
        const uint32_t covered = parts_covered(igloo, cell, piece);
        parts += covered;
        if (covered > 0 && cell < cells) to.covered.push_back({uint32_t(cell), covered});
    });
    if (parts == 0) {
        const uint32_t cell = cell_of(igloo, middle_of(piece));
        if (cell < cells) to.covered.push_back({cell, 1});
    }
    const float share = share_of_part(igloo, piece, parts);
    for (const auto& [cell, covered] : to.covered) {
        const Vec3 w(igloo.center_x[cell], igloo.center_y[cell], igloo.center_z[cell]);
        const float ahead = dot(w, piece.n), aside = dot(w, piece.b);
        size_t of_sums = cell;
        if (!from.sight.empty()) {
            const float distance = piece.foot * std::max(ahead, 0.0f) / std::max(ahead * ahead + aside * aside, 1e-12f);
            if (distance * distance > from.sight[cell]) of_sums += cells;
        }
        Rgbx& sum = to.absorbed[of_sums];
        if (sum.c[3] == 0) to.touched.push_back(uint32_t(of_sums));
        const float sine = std::min(std::sqrt(ahead * ahead + aside * aside), 1.0f);
        const int32_t row = arc.first_opacity_row + opacity_row(sine);
        const Rgbx& o = opacity.row[size_t(row)];
        for (int c = 0; c < 3; ++c) sum.c[c] += share * float(covered) * o.c[c];
        sum.c[3] = 1;
    }
}

inline float end_of(const ArcRow& arc) { return arc.along + arc.length; }

/// Past the last of the arcs from `first` on that follow each other on one axis without a gap.
inline const ArcRow* end_of_run(const ArcRow* first, const ArcRow* last) {
    const ArcRow* arc = first + 1;
    for (float end = end_of(*first); arc != last; ++arc) {
        if (arc->along > end + 0.01f * first->radius) break;
        end = std::max(end, end_of(*arc));
    }
    return arc;
}

/// One arc in place of a run of them.
inline ArcRow joined(const ArcRow* first, const ArcRow* last) {
    const auto radius_at = [](const ArcRow& arc, float place) {
        return arc.radius * (1 + arc.taper * (place - arc.along - 0.5f * arc.length));
    };
    const auto from_foot = [](const ArcRow& arc) { return std::max({arc.along, -end_of(arc), 0.0f}); };
    const ArcRow *high = first, *middle = first;
    for (const ArcRow* arc = first; arc != last; ++arc) {
        if (end_of(*arc) > end_of(*high)) high = arc;
        if (from_foot(*arc) < from_foot(*middle)) middle = arc;
    }
    const float start = first->along, end = end_of(*high);
    const float start_radius = radius_at(*first, start), end_radius = radius_at(*high, end);
    ArcRow whole = *middle;  // knows best which way the foot is
    whole.along = start, whole.length = end - start;
    whole.radius = 0.5f * (start_radius + end_radius);
    whole.taper = (end_radius - start_radius) / std::max(whole.radius * whole.length, 1e-30f);
    return whole;
}

/// Optical depths of what stops these shares, at most kOpaqueDepth.
HWY_INLINE Rgbx depths_of(const Rgbx& share) {
    const hn::CappedTag<float, 4> d;
    const auto whole = hn::Set(d, 1.0f), most = hn::Set(d, kOpaqueDepth);
    Rgbx depth;
    for (size_t i = 0; i < 4; i += hn::Lanes(d))
        hn::Store(hn::Min(minus_log_of_rest(d, hn::Min(hn::Load(d, share.c + i), whole)), most), d, depth.c + i);
    return depth;
}

inline void add_channels(float& cell, const Rgbx& depth) { cell += depth.c[0]; }
inline void add_channels(Rgbx& cell, const Rgbx& depth) { cell += depth; }

/// What one fiber absorbs in each cell becomes depth.
template <class Depth>
void add_fiber(WideFiber& fiber, CellDepths<Depth>& to) {
    for (const uint32_t cell : fiber.touched) {
        add_channels(to.depth[cell], depths_of(fiber.absorbed[cell]));
        fiber.absorbed[cell] = {};
    }
    fiber.touched.clear();
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
