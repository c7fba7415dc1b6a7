// SPDX-License-Identifier: MIT
// Pieces of hair next to a point that are no wider than a cell and a half: which samples of which cells they cover.
#if defined(TRESS_GATHER_PROJECTION_NEAR_FIBER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_GATHER_PROJECTION_NEAR_FIBER_INL_H
#undef TRESS_GATHER_PROJECTION_NEAR_FIBER_INL_H
#else
#define TRESS_GATHER_PROJECTION_NEAR_FIBER_INL_H
#endif

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/frame.h"
#include "gather/projection/arcs.h"
#include "gather/projection/igloo.h"
#include "gather/projection/projection_scratch.h"
#include "gather/projection/vector_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

/// Two half spaces that meet in the point, by their unit normals.
struct Wedge {
    Vec3 normal[2];
};

/// Heights in an igloo's frame.
struct Heights {
    float least, most;
};

/// Heights of a piece whose axis and direction to the foot have these in an igloo's frame, and some more.
inline Heights heights_of(const ArcRow& arc, float axis_z, float normal_z) {
    constexpr float kAllAround = 0.5f;  // width of pieces that may be anywhere
    const float widest = arc.width * (1 + 0.5f * std::abs(arc.taper) * arc.length);
    if (widest > kAllAround) return {-1, 1};
    const float first = arc.along, last = arc.along + arc.length;
    const auto height_at = [&](float place) {
        return (arc.foot * normal_z + place * axis_z) / std::sqrt(square(arc.foot) + square(place));
    };
    Heights heights = {std::min(height_at(first), height_at(last)), std::max(height_at(first), height_at(last))};
    const float apex = arc.foot * axis_z, low = std::min(first * normal_z, last * normal_z),
                high = std::max(first * normal_z, last * normal_z);
    if (low < apex && apex < high)  // where the great circle is highest, or lowest, lies between the ends
        (normal_z > 0 ? heights.most : heights.least) =
            std::copysign(std::sqrt(square(normal_z) + square(axis_z)), normal_z);
    return {heights.least - widest, heights.most + widest};
}

/// A thin piece in the frame of an igloo: a ray meets it that is in both wedges, `beside` its axis and between its
/// ends, and not behind the point. Edges are the planes through the point and where the ribbon is widest at either end.
struct ThinPiece {
    Vec3 axis, normal, across;  // `normal` to the foot of the perpendicular
    Wedge beside, ends;
    Heights heights;  // that it lies between
    float solid_angle;
    Vec3 middle;  // unit

    ThinPiece(const ArcRow& arc, const Frame& frame)
        : axis(frame.to_local(arc.axis)), normal(frame.to_local(arc.normal)), across(cross(axis, normal)) {
        const float foot = arc.foot, first = arc.along, last = arc.along + arc.length;
        const float from = 1 / std::sqrt(square(foot) + square(first)), to = 1 / std::sqrt(square(foot) + square(last));
        const Vec3 start = foot * normal + first * axis, end = foot * normal + last * axis;
        const float rise = 0.5f * arc.taper * arc.length;
        const auto side = [&](float radius) {
            return foot * radius / std::sqrt(square(foot) - square(radius)) * across;
        };
        const Vec3 at_start = side(arc.radius * (1 - rise)), at_end = side(arc.radius * (1 + rise));
        beside = {{normalize(cross(end - at_end, start - at_start)), normalize(cross(start + at_start, end + at_end))}};
        ends = {{from * (foot * axis - first * normal), to * (last * normal - foot * axis)}};
        heights = heights_of(arc, axis.z, normal.z);
        // Of a lune of the width w, cut where its axis' ends are seen: w (s + w^2 / 24 (s - s^3)), s the ends' sines.
        const auto lune = [&](float s) { return s + square(arc.width) / 24 * (s - s * s * s); };
        solid_angle =
            arc.width * ((1 - arc.taper * (first + 0.5f * arc.length)) * (lune(to * last) - lune(from * first)) +
                         arc.taper * square(foot) * (from - to));
        middle = normalize(start + end);
    }
};

/// Calls on_cells(first, end) for the cells of all rows between two heights, of each hemisphere.
template <class OnCells>
HWY_INLINE void for_rows_between(const Igloo& igloo, const Heights& heights, const OnCells& on_cells) {
    const float cells = float(igloo.cells);
    const auto row_at = [&](float height) {
        const float below = cells * (1 - std::clamp(height, 0.0f, 1.0f));
        return uint32_t(igloo.row_of[std::min(uint32_t(below), igloo.cells - 1)]);
    };
    const auto rows = [&](float least, float most, uint32_t offset) {
        const uint32_t top = row_at(most), bottom = row_at(least);
        on_cells((top & 0xffff) + offset, (bottom & 0xffff) + (bottom >> 16) + offset);
    };
    if (heights.most > 0) rows(heights.least, heights.most, 0);
    if (heights.least < 0) rows(-heights.most, -heights.least, igloo.cells);
}

/// A vector of directions.
struct Directions {
    FloatVec x, y, z;

    FloatVec along(const Vec3& v) const { return dot3(x, y, z, set(v.x), set(v.y), set(v.z)); }
    /// The lesser of how far within both half spaces they are.
    FloatVec within(const Wedge& w) const { return hn::Min(along(w.normal[0]), along(w.normal[1])); }
};

/// Calls on_middles(first, middles, end) for vectors of cells between two heights, of which those from `end` on do not
/// count.
template <class OnMiddles>
HWY_INLINE void for_middles_between(const Igloo& igloo, const Heights& heights, const OnMiddles& on_middles) {
    const Floats d;
    for_rows_between(igloo, heights, [&](uint32_t first, uint32_t end) {
        for (uint32_t at = first; at < end; at += uint32_t(hn::Lanes(d)))
            on_middles(at,
                       Directions{hn::LoadU(d, &igloo.center_x[at]), hn::LoadU(d, &igloo.center_y[at]),
                                  hn::LoadU(d, &igloo.center_z[at])},
                       end);
    });
}

/// The bits of a vector's cells from `first` on that count.
HWY_INLINE uint32_t cells_before(uint32_t end, uint32_t first, FloatMask mask) {
    const uint32_t left = end - first, bits = bits_of(mask);
    return left < kMostLanes ? bits & ((1u << left) - 1) : bits;
}

/// Calls on_cell(cell, whole) for each of the sphere that may see the piece, in order; `whole`: all of it lies between
/// the piece's ends.
template <class OnCell>
HWY_INLINE void for_cells_near(const Igloo& igloo, const ThinPiece& p, const OnCell& on_cell) {
    const float reach = std::sin(std::min(igloo.cell_radius, kPi / 2));
    const FloatVec least = set(-reach);
    for_middles_between(igloo, p.heights, [&](uint32_t first, const Directions& middle, uint32_t end) {
        const FloatVec between = middle.within(p.ends);
        const FloatMask may =
            hn::And(hn::Min(middle.within(p.beside), between) >= least, middle.along(p.normal) >= least);
        const uint32_t whole = bits_of(between >= set(reach));
        for (uint32_t bits = cells_before(end, first, may); bits != 0; bits &= bits - 1) {
            const uint32_t lane = uint32_t(std::countr_zero(bits));
            on_cell(first + lane, (whole >> lane & 1) != 0);
        }
    });
}

/// A bit for each sample of a cell that is in the wedge. A sample at the height z and the azimuth phi is on the
/// positive side of a plane with the normal v where v.x cos(phi) + v.y sin(phi) >= -v.z z / sqrt(1 - z^2).
HWY_INLINE uint64_t samples_within(const Igloo& igloo, uint32_t cell, const Wedge& wedge) {
    const Floats d;
    const SampleRows rows = igloo.samples_of(cell);
    constexpr size_t kColumns = Igloo::kColumnEntries;
    HWY_ALIGN float side[2][kColumns];
    for (int k = 0; k < 2; ++k)
        for (size_t i = 0; i < kColumns; i += hn::Lanes(d))
            hn::Store(set(wedge.normal[k].x) * hn::LoadU(d, rows.cosine + i) +
                          set(wedge.normal[k].y) * hn::LoadU(d, rows.sine + i),
                      d, side[k] + i);
    const FloatVec z0 = set(-rows.up * wedge.normal[0].z), z1 = set(-rows.up * wedge.normal[1].z);
    uint64_t bits = 0;
    for (size_t i = 0; i < Igloo::kSamples; i += hn::Lanes(d)) {
        const FloatVec slope = hn::LoadU(d, rows.slope + i);
        const FloatMask within = hn::And(hn::Load(d, side[0] + i % kColumns) >= z0 * slope,
                                         hn::Load(d, side[1] + i % kColumns) >= z1 * slope);
        bits |= uint64_t(bits_of(within)) << i;
    }
    return bits;
}

/// Where a piece covers a cell, and by how much.
struct CoveredCell {
    Vec3 middle;    // of the cell
    uint32_t cell;  // of the dome
    float share;    // of its solid angle
    uint64_t samples;
};

/// Adds a piece of `arc` in one cell; `normal` and `across` as in ThinPiece.
inline void add_covered(const Viewpoint& from, size_t cells, const HairOpacity& opacity, const ArcRow& arc,
                        const Vec3& normal, const Vec3& across, const CoveredCell& covered, NearCells& to) {
    const float ahead = dot(covered.middle, normal), aside = dot(covered.middle, across);
    const float squared = ahead * ahead + aside * aside, sine = std::min(std::sqrt(squared), 1.0f);
    const float distance = arc.foot * std::max(ahead, 0.0f) / std::max(squared, 1e-12f);
    const bool hidden = !from.sight.empty() && distance * distance > from.sight[covered.cell];
    to.cells[covered.cell + (hidden ? cells : 0)].add(arc.segment, covered.share, covered.samples,
                                                      opacity.row[size_t(arc.first_opacity_row + opacity_row(sine))]);
}

inline Vec3 center_of(const Igloo& igloo, size_t cell) {
    return {igloo.center_x[cell], igloo.center_y[cell], igloo.center_z[cell]};
}

/// Adds a thin piece: its solid angle is spread over cells as its samples are; with none, all of it is in the cell of
/// its middle.
inline void cover_thin(const Igloo& igloo, const Viewpoint& from, const HairOpacity& opacity, const ArcRow& arc,
                       ProjectionScratch& scratch) {
    const ThinPiece piece(arc, from.frame);
    const size_t cells = igloo.cells_of(from.dome);
    auto& list = scratch.covered;
    list.clear();
    int samples = 0;
    for_cells_near(igloo, piece, [&](uint32_t cell, bool whole) {
        uint64_t within = samples_within(igloo, cell, piece.beside);
        if (!whole) within &= samples_within(igloo, cell, piece.ends);
        samples += std::popcount(within);
        if (within != 0 && cell < cells) list.push_back({cell, within, 0});
    });
    if (samples == 0) {
        const uint32_t cell = cell_of(igloo, piece.middle);
        if (cell < cells) list.push_back({cell, 0, 0});
    }
    const float whole = piece.solid_angle / igloo.solid_angle();
    for (const auto& seen : list) {
        const float share = samples == 0 ? whole : whole * float(std::popcount(seen.samples)) / float(samples);
        add_covered(from, cells, opacity, arc, piece.normal, piece.across,
                    {center_of(igloo, seen.cell), seen.cell, share, seen.samples}, scratch.near);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
