// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/hair_fragments.h"

#include <hwy/cache_control.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "gather/shadow_maps/draw_ribbon.h"
#include "gather/shadow_maps/fragment_sorter.h"
#include "gather/shadow_maps/tile_bins.h"
#include "gather/shadow_maps/tile_pieces.h"

namespace tress {
namespace {

/// Pieces that are fetched before they are drawn: those of a full tile fill more than the nearer caches.
constexpr size_t kAhead = 8;

struct Scratch {
    std::vector<RibbonPiece> pieces;
    std::vector<uint32_t> order, place;  // of pieces
    FragmentSorter sorter;
    FragmentTile tile;
};

/// The order in which pieces are drawn. One pass of a bucket sort: near enough to the order of depth for what follows
/// to be quick.
void sort_roughly(Scratch& scratch) {
    constexpr size_t kBuckets = 2048;
    float low = kInfinity, high = -kInfinity;
    for (const RibbonPiece& p : scratch.pieces)
        low = std::min(low, middle_depth(p)), high = std::max(high, middle_depth(p));
    const float scale = high > low ? float(kBuckets - 1) / (high - low) : 0;
    const auto bucket = [&](const RibbonPiece& p) {
        const float at = (middle_depth(p) - low) * scale;
        return at > 0 ? size_t(std::min(at, float(kBuckets - 1))) : 0;
    };
    scratch.place.assign(kBuckets, 0);
    for (const RibbonPiece& p : scratch.pieces) ++scratch.place[bucket(p)];
    uint32_t total = 0;
    for (uint32_t& p : scratch.place) p = (total += p) - p;
    scratch.order.resize(scratch.pieces.size());
    for (uint32_t i = 0; i < scratch.pieces.size(); ++i) scratch.order[scratch.place[bucket(scratch.pieces[i])]++] = i;
}

/// Draws a ribbon that is not thin into texels `rect` of the tile that starts there; sets what it stops, at the middle
/// of what is seen of it in the tile.
void draw_whole(const HairInView& hair, const TexelRect& rect, uint32_t index, RibbonPiece& piece,
                FragmentSorter& sorter, const auto& take) {
    const std::optional<Ribbon> ribbon = make_ribbon(hair.view, hair.segments, piece.segment);
    const RibbonOutline o = outline(hair.view, *ribbon);
    glm::dvec2 low(rect.high), high(rect.low);
    for (int k = 0; k < o.corners; ++k) low = min(low, o.corner[size_t(k)]), high = max(high, o.corner[size_t(k)]);
    low = max(low, glm::dvec2(rect.low)), high = min(high, glm::dvec2(rect.high));
    piece.stopped = stopped_light(hair, *ribbon, piece.segment, 0.5 * (low + high));
    sorter.begin_piece(index, piece.stopped, size_t(kViewTile * kViewTile));
    draw_outline(hair.view, *ribbon, o, rect.low, rect, take);
}

void draw_tile(const HairInView& hair, const TileBins& bins, float opaque, int tile, Scratch& s) {
    const glm::ivec2 low(tile % tiles_across(hair.view) * kViewTile, tile / tiles_across(hair.view) * kViewTile);
    const TexelRect rect{low, min(low + kViewTile, glm::ivec2(hair.view.width, hair.view.height))};
    cut_into_pieces(hair, bins.of(tile), rect, s.pieces);
    sort_roughly(s);
    s.sorter.begin(hair.channels, s.pieces.size(), opaque);
    const auto take = [&](int texel, float coverage, float depth) { s.sorter.add(texel, coverage, depth); };
    for (size_t i = 0; i < s.order.size(); ++i) {
        hwy::Prefetch(&s.pieces[s.order[std::min(i + kAhead, s.order.size() - 1)]]);
        const uint32_t index = s.order[i];
        RibbonPiece& piece = s.pieces[index];
        if (piece.shape != uint16_t(Ribbon::Shape::thin)) {
            draw_whole(hair, rect, index, piece, s.sorter, take);
            continue;
        }
        // A column of a thin ribbon rises by a texel at most and is half of one wide: three rows, and rounding.
        s.sorter.begin_piece(index, piece.stopped, 4 * (kPieceTexels + 1));
        draw_thin(piece, rect.high[1 - piece.major] - rect.low[1 - piece.major], take);
    }
    s.sorter.finish(s.tile);
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

void project_hair(const LightView& view, const SegmentView& segments, const Attenuation& attenuation, float opaque,
                  const std::function<void(int tile, FragmentTile& fragments)>& take) {
    const HairInView hair{view, segments, attenuation, colors_light(attenuation) ? 3 : 1};
    const TileBins bins = bin_segments(view, segments);
    tbb::enumerable_thread_specific<Scratch> scratch;
    tbb::parallel_for(0, tile_count(view), [&](int tile) {
        Scratch& s = scratch.local();
        draw_tile(hair, bins, opaque, tile, s);
        // What waits within `take` must not run another tile on this thread's scratch.
        tbb::this_task_arena::isolate([&] { take(tile, s.tile); });
    });
}

}  // namespace tress
