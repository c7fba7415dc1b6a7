// SPDX-License-Identifier: MIT
// Every segment projected: one splat for those that are small from the point, two or four for those that are not much
// longer, exact arcs for the rest.
#if defined(TRESS_GATHER_PROJECTION_ALL_SEGMENTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TRESS_GATHER_PROJECTION_ALL_SEGMENTS_INL_H
#undef TRESS_GATHER_PROJECTION_ALL_SEGMENTS_INL_H
#else
#define TRESS_GATHER_PROJECTION_ALL_SEGMENTS_INL_H
#endif

#include <algorithm>
#include <limits>
#include <vector>

#include "gather/projection/arcs-inl.h"
#include "gather/projection/projection_kernels.h"
#include "gather/projection/segment_splats-inl.h"
#include "hwy/cache_control.h"

HWY_BEFORE_NAMESPACE();
namespace tress {
namespace HWY_NAMESPACE {

/// Projects rows of segments from one point: as many at once whatever the vectors hold, so that sums are the same on
/// every instruction set.
template <class Depth>
class RowProjection {
public:
    RowProjection(const ProjectionInput& in, const Viewpoint& from, const Unseen& unseen, ProjectionScratch& scratch,
                  CellDepths<Depth>& to)
        : in_(in), from_(from), unseen_(unseen), scratch_(scratch), to_(to) {}

    /// Rows [0, rows) of `s`, a multiple of kMostLanes.
    void project(const ProjectedSegments& s, size_t rows) {
        constexpr size_t kAtOnce = 1 << 16;  // places in their block and entries of NearRows are of 32 bits
        static_assert(kAtOnce % kMostLanes == 0 && P::kStreams == kMostLanes);
        for (size_t first = 0; first < rows; first += kAtOnce) project(s, first, std::min(kAtOnce, rows - first));
    }

    /// Draws what is left of all rows.
    void finish() {
        add_to_cells(in_.opacity, scratch_.segment_splats, to_);
        finish_pieces(in_, from_, scratch_, to_);
    }

private:
    using P = ProjectedSegments;

    void project(const ProjectedSegments& s, size_t first, size_t rows) {
        constexpr size_t kAhead = 16 * kMostLanes;
        const SplatBounds bounds(in_.igloo.cell_size(), in_.near);
        CellSplats& splats = scratch_.segment_splats;
        NearRows& near = scratch_.near_rows;
        for (size_t i = 0; i < rows; i += kMostLanes) {
            prefetch(s, first + std::min(i + kAhead, rows - kMostLanes));
            make_room(splats, kMostLanes);
            splat_rows(in_.igloo, bounds, s, first, i, from_, splats, near);
            add_kinds([&](size_t lane) { return s.original(first + i + lane); }, splats.size - kMostLanes, splats);
            if (!near.all.has_room(kMostLanes)) draw_near(s, first);
        }
        draw_near(s, first);
    }

    /// A vector's rows. What reads memory in order on its own does not look far enough ahead.
    static void prefetch(const ProjectedSegments& s, size_t row) {
        for (int c = 0; c < P::kColumns; ++c) hwy::Prefetch(&s.values[s.place(row, P::Column(c))]);
    }

    void make_room(CellSplats& splats, size_t rows) {
        if (!splats.has_room(rows)) add_to_cells(in_.opacity, splats, to_);
    }
    /// To the rows of opacity of kMostLanes splats from `at` on; original_of(lane) is the scene's segment of each.
    template <class Original>
    void add_kinds(const Original& original_of, size_t at, CellSplats& splats) {
        if (in_.opacity.kind.empty()) return;
        for (size_t lane = 0; lane < kMostLanes; ++lane)
            splats.opacity_row[at + lane] += int32_t(in_.opacity.kind[original_of(lane)]) * kOpacityRows;
    }

    static constexpr int32_t kAfterAll = std::numeric_limits<int32_t>::max();  // segments

    /// Empties the lists of near rows of `s` from `first` on.
    void draw_near(const ProjectedSegments& s, size_t first) {
        NearRows& near = scratch_.near_rows;
        sort_by_way(near);
        draw_parts<2>(s, first, near.of_way[int(NearWay::halved)]);
        draw_parts<4>(s, first, near.of_way[int(NearWay::quartered)]);
        draw_exactly(s, first, near.of_way[int(NearWay::exact)]);
    }

    /// A splat for each of kParts parts of the segments.
    template <int kParts>
    void draw_parts(const ProjectedSegments& s, size_t first, RowList& list) {
        const Floats d;
        const Ints di;
        HWY_ALIGN int32_t original[kMostLanes];
        CellSplats& splats = scratch_.segment_splats;
        for (size_t at = 0; at < list.size; at += kMostLanes) {
            make_room(splats, kParts * kMostLanes);
            for (size_t i = 0; i < kMostLanes; i += hn::Lanes(d)) {
                const auto listed = counted_from(int32_t(at + i)) < hn::Set(di, int32_t(list.size));
                const RowsOf rows(s, first, hn::IfThenElseZero(listed, hn::Load(di, &list.row[at + i])));
                const SegmentVec whole = segments_at(rows, from_);
                const FloatVec taper = rows(P::kTaper);
                const IntVec segment = hn::BitCast(di, rows(P::kOriginal));
                hn::Store(segment, di, original + i);
                const int32_t before = unseen_.any() ? int32_t(unseen_.first) - int32_t(s.stands_for) : kAfterAll;
                const auto from_first = segment > hn::Set(di, before);
                const auto past_last = segment > hn::Set(di, int32_t(unseen_.last));
                const FloatMask seen = hn::RebindMask(d, hn::AndNot(hn::AndNot(past_last, from_first), listed));
                for (size_t part = 0; part < kParts; ++part) {
                    const float place = float(2 * part + 1) / kParts - 1;  // of its middle, in halves of the segment
                    splat_segments(
                        in_.igloo, from_, parts_of(whole, taper, place, 1.0f / kParts),
                        [&](const SeenSize&) { return hn::Not(seen); }, splats.size + part * kMostLanes + i, splats);
                }
            }
            for (size_t part = 0; part < kParts; ++part)
                add_kinds([&](size_t lane) { return uint32_t(original[lane]); }, splats.size + part * kMostLanes,
                          splats);
            splats.size += kParts * kMostLanes;
        }
        list.size = 0;
    }

    void draw_exactly(const ProjectedSegments& s, size_t first, RowList& list) {
        for (size_t i = 0; i < list.size; ++i) {
            const size_t row = first + size_t(list.row[i]);
            const uint32_t original = s.original(row);
            if (unseen_.holds(original, s.stands_for)) continue;
            if (scratch_.pieces.full()) draw_pieces(in_, from_, scratch_, to_);
            const Vec3 middle = s.middle(row) - from_.position, half = 0.5f * s.at(row, P::kLength) * s.tangent(row);
            const float radius = s.at(row, P::kRadius), taper = s.at(row, P::kTaper);
            scratch_.pieces.add(middle - half, middle + half, radius - taper, radius + taper, 0,
                                in_.opacity.kind_of(original), original);
        }
        list.size = 0;
    }

    const ProjectionInput& in_;
    const Viewpoint& from_;
    const Unseen& unseen_;
    ProjectionScratch& scratch_;
    CellDepths<Depth>& to_;
};

template <class Depth>
void project_segments(const ProjectionInput& in, const Viewpoint& from, const Unseen& unseen,
                      ProjectionScratch& scratch, CellDepths<Depth>& to) {
    RowProjection projection(in, from, unseen, scratch, to);
    projection.project(in.segments, in.segments.rows());
    projection.finish();
}

/// Those of scratch.chosen, as wide as their weights say.
template <class Depth>
void project_chosen(const ProjectionInput& in, const Viewpoint& from, const Unseen& unseen, ProjectionScratch& scratch,
                    CellDepths<Depth>& to) {
    using P = ProjectedSegments;
    constexpr size_t kCopied = 1024;
    const std::vector<ChosenSegment>& chosen = scratch.chosen;
    P& some = scratch.chosen_rows;
    if (some.rows() == 0) some = P(kCopied);
    RowProjection projection(in, from, unseen, scratch, to);
    for (size_t first = 0; first < chosen.size(); first += kCopied) {
        const size_t count = std::min(kCopied, chosen.size() - first), rows = hwy::RoundUpTo(count, kMostLanes);
        for (size_t i = 0; i < count; ++i) {
            const auto [segment, weight] = chosen[first + i];
            const size_t row = in.segments.row_of(segment);
            for (int c = 0; c < P::kColumns; ++c) some.at(i, P::Column(c)) = in.segments.at(row, P::Column(c));
            some.at(i, P::kRadius) *= weight, some.at(i, P::kTaper) *= weight;
        }
        for (size_t i = count; i < rows; ++i)
            for (int c = 0; c < P::kColumns; ++c) some.at(i, P::Column(c)) = 0;
        projection.project(some, rows);
    }
    projection.finish();
}

}  // namespace HWY_NAMESPACE
}  // namespace tress
HWY_AFTER_NAMESPACE();

#endif
