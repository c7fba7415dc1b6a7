// SPDX-License-Identifier: MIT
// Segments as splats: one each for those that are small from the point; those too near for that are listed.
#if defined(TRESS_GATHER_PROJECTION_SEGMENT_SPLATS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_GATHER_PROJECTION_SEGMENT_SPLATS_INL_H
#undef TRESS_GATHER_PROJECTION_SEGMENT_SPLATS_INL_H
#else
#define TRESS_GATHER_PROJECTION_SEGMENT_SPLATS_INL_H
#endif

#include <algorithm>

#include "gather/projection/add_splats-inl.h"
#include "gather/projection/arcs-inl.h"
#include "gather/projection/projection_scratch.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

inline constexpr float kLongestSplat = 1.5f;  // cells: the error of light is that of shorter ones

/// The largest segments that splats stand for, in distances from the point. A point's own fiber reaches kOwnStrandRadii
/// along the strand, from where even segments are longer or wider: leaving it out is left to what is not one splat.
struct SplatBounds {
    float longest;      // segment that is one splat
    float halved;       // longest of two splats
    float quartered;    // longest of four, whose quarters are nearly as far away as its middle
    float widest;       // of one splat
    float widest_part;  // of several: a part may be a quarter nearer, and three quarters wider by its taper

    SplatBounds(float cell_size, float near)
        : longest(std::min(kLongestSplat * cell_size, 0.25f)),
          halved(std::min(2 * longest, 0.5f)),
          quartered(std::min(4 * longest, 0.65f)),
          widest(std::min(near * cell_size, 0.1f)),
          widest_part(0.4f * widest) {}
};

/// Squared sine between a segment and the direction to it below which it is drawn exactly: what is left of 1 - cosine^2
/// by rounding is 2e-7, a thousandth of this one's root.
inline constexpr float kEndOn = 1e-4f;

/// Rows one after another, and rows of a list: each reads its lanes of a column.
struct RowsFrom {
    const float* values;  // of the first row

    RowsFrom(const ProjectedSegments& s, size_t first) : values(&s.values[s.place(first, ProjectedSegments::kX)]) {}
    HWY_INLINE FloatVec operator()(ProjectedSegments::Column c) const {
        return hn::Load(Floats(), values + c * ProjectedSegments::kStreams);
    }
};
struct RowsOf {
    const float* values;  // of row `first`, from which rows are counted, a multiple of kStreams
    IntVec place;

    RowsOf(const ProjectedSegments& s, size_t first, IntVec row)
        : values(&s.values[s.place(first, ProjectedSegments::kX)]) {
        constexpr int kStreams = ProjectedSegments::kStreams, kColumns = ProjectedSegments::kColumns;
        const Ints di;
        const IntVec lane = hn::And(row, hn::Set(di, kStreams - 1));
        place = (row - lane) * hn::Set(di, kColumns) + lane;
    }
    HWY_INLINE FloatVec operator()(ProjectedSegments::Column c) const {
        return hn::GatherIndex(Floats(), values + c * ProjectedSegments::kStreams, place);
    }
};

/// A vector of segments, or of parts of them: middles relative to the point, tangents.
struct SegmentVec {
    FloatVec x, y, z, ux, uy, uz, length, radius;
};

template <class Rows>
HWY_INLINE SegmentVec segments_at(const Rows& rows, const Viewpoint& from) {
    using P = ProjectedSegments;
    return {rows(P::kX) - set(from.position.x),
            rows(P::kY) - set(from.position.y),
            rows(P::kZ) - set(from.position.z),
            rows(P::kUx),
            rows(P::kUy),
            rows(P::kUz),
            rows(P::kLength),
            rows(P::kRadius)};
}

/// Of each, the part of a `share` of its length about a place on it, from -1 to 1.
HWY_INLINE SegmentVec parts_of(const SegmentVec& v, FloatVec taper, float place, float share) {
    const FloatVec along = set(0.5f * place) * v.length;
    return {v.x + along * v.ux,    v.y + along * v.uy,           v.z + along * v.uz, v.ux, v.uy, v.uz,
            set(share) * v.length, v.radius + set(place) * taper};
}

/// What decides how a segment is drawn: squares of length and width over those of the distance, of the sine between
/// tangent and direction.
struct SeenSize {
    FloatVec length, width, sine;
};

/// A vector of segments as one splat each, at rows `at` and on: solid angle 2 r L sin(alpha) / d^2 (1 + (5 g^2 - L^2) /
/// (8 d^2)), with alpha the angle between tangent and direction and g = L cos(alpha): the integral over the axis up to
/// the fourth power of L / d. left_out(size): those whose splats shall cover nothing.
template <class LeftOut>
HWY_INLINE void splat_segments(const Igloo& igloo, const Viewpoint& from, const SegmentVec& v, const LeftOut& left_out,
                               size_t at, CellSplats& to) {
    const Ints di;
    const FloatVec one = set(1.0f);
    const SeenPlaces middle = places(v.x, v.y, v.z);
    const FloatVec along = dot3(v.x, v.y, v.z, v.ux, v.uy, v.uz);
    const FloatVec across = hn::Max(middle.squared - along * along, hn::Zero(Floats()));
    const FloatVec length = v.length * middle.inverse, width = (v.radius + v.radius) * middle.inverse;
    const FloatVec sine_squared = hn::Min(across * middle.inverse * middle.inverse, one);
    const SeenSize size = {length * length, width * width, sine_squared};
    const FloatVec sine = hn::Sqrt(size.sine);
    const FloatVec higher = one + size.length * (set(0.5f) - set(0.625f) * size.sine);
    find_cells(igloo, from, middle, hn::IfThenZeroElse(left_out(size), length * width * sine * higher), at, to);
    hn::StoreU(opacity_rows(Floats(), sine), di, &to.opacity_row[at]);
}

/// Appends those of a vector of rows.
HWY_INLINE void append(IntVec rows, hn::Mask<Ints> which, RowList& to) {
    const Ints di;
    hn::StoreU(hn::Compress(rows, which), di, &to.row[to.size]);
    to.size += hn::CountTrue(di, which);
}

/// Empties near.all into the lists of each way.
inline void sort_by_way(NearRows& near) {
    const Ints di;
    for (size_t i = 0; i < near.all.size; i += hn::Lanes(di)) {
        const IntVec entry = hn::Load(di, &near.all.row[i]), row = hn::ShiftRight<NearRows::kWayBits>(entry);
        const IntVec way = hn::And(entry, hn::Set(di, (1 << NearRows::kWayBits) - 1));
        const auto listed = counted_from(int32_t(i)) < hn::Set(di, int32_t(near.all.size));
        for (int w = 0; w < NearRows::kWays; ++w) append(row, hn::And(way == hn::Set(di, w), listed), near.of_way[w]);
    }
    near.all.size = 0;
}

/// kMostLanes rows of `s`, those `at` from `first` on, as splats past the last of `to`, but for those too near. No
/// branch asks whether a segment is near: in a vector of them some often are, and it would be foretold badly.
HWY_INLINE void splat_rows(const Igloo& igloo, const SplatBounds& bounds, const ProjectedSegments& s, size_t first,
                           size_t at, const Viewpoint& from, CellSplats& to, NearRows& near) {
    const Ints di;
    for (size_t i = 0; i < kMostLanes; i += hn::Lanes(di)) {
        const auto list_near = [&](const SeenSize& seen) {
            const auto longer = [&](float than) { return seen.length > set(square(than)); };
            const auto wider = [&](float than) { return seen.width > set(square(than)); };
            const FloatMask parted = longer(bounds.longest);
            const FloatMask never_parted = hn::Or(wider(bounds.widest), seen.sine < set(kEndOn));
            const FloatMask exact =
                hn::Or(hn::Or(never_parted, longer(bounds.quartered)), hn::And(parted, wider(bounds.widest_part)));
            const FloatMask is_near = hn::Or(parted, exact);
            const auto way = [&](NearWay w) { return hn::Set(di, int32_t(w)); };
            const IntVec parts = hn::IfThenElse(hn::RebindMask(di, longer(bounds.halved)), way(NearWay::quartered),
                                                way(NearWay::halved));
            const IntVec ways = hn::IfThenElse(hn::RebindMask(di, exact), way(NearWay::exact), parts);
            const IntVec row = counted_from(int32_t(at + i));
            append(hn::ShiftLeft<NearRows::kWayBits>(row) + ways, hn::RebindMask(di, is_near), near.all);
            return is_near;
        };
        splat_segments(igloo, from, segments_at(RowsFrom(s, first + at + i), from), list_near, to.size + i, to);
    }
    to.size += kMostLanes;
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
