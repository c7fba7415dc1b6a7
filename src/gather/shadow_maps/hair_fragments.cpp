// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/hair_fragments.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "gather/shadow_maps/draw_ribbon.h"
#include "gather/shadow_maps/fragment_sorter.h"
#include "gather/shadow_maps/tile_bins.h"

namespace tress {
namespace {

/// Texels along a ribbon that share one look-up of what it stops: of 90 degrees in 512 texels, the light's direction
/// changes by 1.5 degrees.
constexpr int kPieceTexels = 8;

struct Scratch {
    std::vector<BinnedSegment> roughly_sorted;
    std::vector<uint32_t> place;
    FragmentSorter sorter;
    FragmentTile tile;
};

/// One pass of a bucket sort: near enough to the order of depth for what follows to be quick.
void sort_roughly(std::span<const BinnedSegment> binned, Scratch& scratch) {
    constexpr size_t kBuckets = 2048;
    float low = kInfinity, high = -kInfinity;
    for (const BinnedSegment& b : binned) low = std::min(low, b.z), high = std::max(high, b.z);
    const float scale = high > low ? float(kBuckets - 1) / (high - low) : 0;
    const auto bucket = [&](const BinnedSegment& b) {
        const float at = (b.z - low) * scale;
        return at > 0 ? std::min(size_t(at), kBuckets - 1) : 0;
    };
    scratch.place.assign(kBuckets, 0);
    for (const BinnedSegment& b : binned) ++scratch.place[bucket(b)];
    uint32_t total = 0;
    for (uint32_t& p : scratch.place) p = (total += p) - p;
    scratch.roughly_sorted.resize(binned.size());
    for (const BinnedSegment& b : binned) scratch.roughly_sorted[scratch.place[bucket(b)]++] = b;
}

struct Hair {
    const LightView& view;
    const SegmentView& segments;
    const Attenuation& attenuation;
    int channels;

    RibbonPiece piece(const Ribbon& ribbon, uint32_t segment, const glm::dvec2& place) const {
        const Rgb depth = attenuation.depth(segment, float(abs_sin_theta(view, ribbon, place)));
        RibbonPiece piece{segment, Rgb(0)};
        for (int c = 0; c < channels; ++c) piece.stopped[c] = -std::expm1(-depth[c]);
        return piece;
    }
};

void draw(const Hair& hair, const Ribbon& r, uint32_t segment, const TexelRect& rect, FragmentSorter& sorter) {
    const auto take = [&](int x, int y, double coverage, double z) {
        sorter.add(y % kViewTile * kViewTile + x % kViewTile, float(coverage), float(z - hair.view.start));
    };
    if (r.shape == Ribbon::Shape::thin) {
        const int major = r.major;
        const double from = std::max(r.at[0][major], double(rect.low[major]));
        const double to = std::min(r.at[1][major], double(rect.high[major]));
        if (!(from < to)) return;
        const int last = int(std::ceil(to));
        for (int first = int(from); first < last; first += kPieceTexels) {
            const int end = std::min(first + kPieceTexels, last);
            const double middle = 0.5 * (std::max(from, double(first)) + std::min(to, double(end)));
            const double u = (middle - r.at[0][major]) / (r.at[1][major] - r.at[0][major]);
            // A column of a thin ribbon rises by a texel and is half of one wide: three rows at most.
            sorter.begin_piece(hair.piece(r, segment, r.at[0] + u * (r.at[1] - r.at[0])), 4 * kPieceTexels);
            draw_thin(hair.view, r, rect, first, end, take);
        }
        return;
    }
    const RibbonOutline o = outline(hair.view, r);
    for (int y = rect.low.y; y < rect.high.y; y += kPieceTexels)
        for (int x = rect.low.x; x < rect.high.x; x += kPieceTexels) {
            const glm::ivec2 low(x, y);
            const TexelRect part{low, min(low + kPieceTexels, rect.high)};
            const glm::dvec2 middle = 0.5 * glm::dvec2(part.low + part.high);
            sorter.begin_piece(hair.piece(r, segment, middle), size_t(kPieceTexels * kPieceTexels));
            draw_outline(hair.view, r, o, part, take);
        }
}

}  // namespace

bool colors_light(const Attenuation& attenuation) {
    const auto is_grey = [](const Rgb& v) { return v.x == v.y && v.y == v.z; };
    if (!attenuation.sigma_a.empty())
        return !std::all_of(attenuation.sigma_a.begin(), attenuation.sigma_a.end(), is_grey);
    return !std::all_of(attenuation.table.begin(), attenuation.table.end(), [&](const AttenuationTable& table) {
        return std::all_of(table.depth.begin(), table.depth.end(), is_grey);
    });
}

void project_hair(const LightView& view, const SegmentView& segments, const Attenuation& attenuation,
                  const std::function<void(int tile, FragmentTile& fragments)>& take) {
    const TileBins bins = bin_segments(view, segments);
    const Hair hair{view, segments, attenuation, colors_light(attenuation) ? 3 : 1};
    tbb::enumerable_thread_specific<Scratch> scratch;
    tbb::parallel_for(0, tile_count(view), [&](int tile) {
        Scratch& s = scratch.local();
        const glm::ivec2 low(tile % tiles_across(view) * kViewTile, tile / tiles_across(view) * kViewTile);
        const TexelRect rect{low, min(low + kViewTile, glm::ivec2(view.width, view.height))};
        sort_roughly(bins.of(tile), s);
        s.sorter.begin(hair.channels);
        for (const BinnedSegment& b : s.roughly_sorted)
            draw(hair, *make_ribbon(view, segments, b.segment), b.segment, rect, s.sorter);
        s.sorter.finish(s.tile);
        // What waits within `take` must not run another tile on this thread's scratch.
        tbb::this_task_arena::isolate([&] { take(tile, s.tile); });
    });
}

}  // namespace tress
