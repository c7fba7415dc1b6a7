// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/tile_bins.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace tress {
namespace {

/// Parts of the list of segments that are binned each on its own, one after another. Not the number of threads, on
/// which the result would then depend; enough for any.
constexpr size_t kParts = 64;

/// What a part holds beside its pieces.
struct PartTiles {
    std::vector<uint32_t> piece, tile;  // one a piece in a tile
    std::vector<uint64_t> placed;       // one a tile: how many of it; then where the next goes
};

/// Box [low, high] of texels, as numbers.
struct Box {
    glm::dvec2 low{1e300}, high{-1e300};
    void add(const glm::dvec2& p) { low = min(low, p), high = max(high, p); }
};

/// Box of a thin ribbon between two places of its major axis; of nothing where there is none.
Box thin_box(const Ribbon& r, double from, double to) {
    Box box;
    const int major = r.major, minor = 1 - major;
    from = std::max(from, r.at[0][major]), to = std::min(to, r.at[1][major]);
    if (!(from <= to)) return box;
    for (const double at : {from, to}) {
        const double u = (at - r.at[0][major]) / (r.at[1][major] - r.at[0][major]);
        glm::dvec2 p(0);
        p[major] = at;
        p[minor] = r.at[0][minor] + u * (r.at[1][minor] - r.at[0][minor]);
        glm::dvec2 across(0);
        across[minor] = std::max(r.half_width[0], r.half_width[1]);
        box.add(p - across), box.add(p + across);
    }
    return box;
}

/// Tiles [low, high) that a box touches.
TexelRect tiles_of(const LightView& view, const Box& box) {
    const auto index = [](double texel, int size) {
        return int(std::clamp(texel, 0.0, double(size))) / kViewTile;  // towards zero is down
    };
    TexelRect tiles{{0, 0}, {0, 0}};
    if (!(box.low.x < view.width && box.low.y < view.height && box.high.x > 0 && box.high.y > 0)) return tiles;
    tiles.low = {index(box.low.x, view.width), index(box.low.y, view.height)};
    tiles.high = {std::min(index(box.high.x, view.width) + 1, tiles_across(view)),
                  std::min(index(box.high.y, view.height) + 1, tiles_down(view))};
    return tiles;
}

/// Whether all of a tile lies outside one edge of a convex outline.
bool misses(const RibbonOutline& o, const glm::ivec2& tile) {
    const glm::dvec2 middle = (glm::dvec2(tile) + 0.5) * double(kViewTile);
    double area = 0;
    for (int k = 0; k < o.corners; ++k) {
        const glm::dvec2 p = o.corner[size_t(k)], q = o.corner[size_t((k + 1) % o.corners)];
        area += p.x * q.y - p.y * q.x;
    }
    for (int k = 0; k < o.corners; ++k) {
        const glm::dvec2 p = o.corner[size_t(k)];
        const glm::dvec2 edge = o.corner[size_t((k + 1) % o.corners)] - p, from = middle - p;
        const double inward = (area < 0 ? -1 : 1) * (edge.x * from.y - edge.y * from.x);
        if (inward < -0.5 * kViewTile * (std::abs(edge.x) + std::abs(edge.y))) return true;
    }
    return false;
}

template <class Take>
void for_each_tile(const LightView& view, const Ribbon& r, const Take& take) {
    if (r.shape != Ribbon::Shape::thin) {
        const RibbonOutline o = outline(view, r);
        Box box;
        for (int k = 0; k < o.corners; ++k) box.add(o.corner[size_t(k)]);
        const TexelRect tiles = tiles_of(view, box);
        const bool one = tiles.high.x - tiles.low.x == 1 && tiles.high.y - tiles.low.y == 1;
        for (int y = tiles.low.y; y < tiles.high.y; ++y)
            for (int x = tiles.low.x; x < tiles.high.x; ++x)
                if (one || !misses(o, {x, y})) take(x, y);
        return;
    }
    const int major = r.major;
    const TexelRect all = tiles_of(view, thin_box(r, r.at[0][major], r.at[1][major]));
    const bool straight = all.high[0] - all.low[0] <= 1 || all.high[1] - all.low[1] <= 1;
    for (int i = all.low[major]; i < all.high[major]; ++i) {
        TexelRect tiles = all;
        if (!straight) tiles = tiles_of(view, thin_box(r, i * kViewTile, (i + 1) * kViewTile));
        for (int j = tiles.low[1 - major]; j < tiles.high[1 - major]; ++j) major == 0 ? take(i, j) : take(j, i);
    }
}

/// Calls `take(piece)` for the pieces of a thin ribbon in one tile, cut at columns of texels.
template <class Take>
void cut_into_pieces(const HairInView& hair, const Ribbon& r, uint32_t segment, const glm::ivec2& corner,
                     const Take& take) {
    const int major = r.major;
    const int end = std::min(corner[major] + kViewTile, major == 0 ? hair.view.width : hair.view.height);
    const double from = std::max(r.at[0][major], double(corner[major]));
    const double to = std::min(r.at[1][major], double(end));
    if (!(from < to)) return;
    for (int first = int(from); first < to; first += kPieceTexels) {
        const double low = std::max(from, double(first)), high = std::min(to, double(first + kPieceTexels));
        RibbonPiece piece = cut_thin(hair.view, r, low, high, corner);
        const double u = (0.5 * (low + high) - r.at[0][major]) / (r.at[1][major] - r.at[0][major]);
        const glm::dvec2 middle = r.at[0] + u * (r.at[1] - r.at[0]);
        piece.segment = segment;
        piece.stopped = stopped_light(hair, r, segment, middle);
        take(piece);
    }
}

void bin_part(const HairInView& hair, size_t first, size_t last, std::vector<RibbonPiece>& pieces, PartTiles& tiles) {
    tiles.placed.assign(size_t(tile_count(hair.view)), 0);
    const size_t likely = (last - first) * 3 / 2;  // where segments are a few texels long and all are seen
    pieces.reserve(likely), tiles.piece.reserve(likely), tiles.tile.reserve(likely);
    for (size_t s = first; s < last; ++s) {
        const std::optional<Ribbon> ribbon = make_ribbon(hair.view, hair.segments, uint32_t(s));
        if (!ribbon) continue;
        const bool thin = ribbon->shape == Ribbon::Shape::thin;
        if (!thin) pieces.push_back(whole_piece(hair.view, *ribbon, uint32_t(s)));
        for_each_tile(hair.view, *ribbon, [&](int x, int y) {
            const auto add = [&, tile = uint32_t(y * tiles_across(hair.view) + x)] {
                tiles.piece.push_back(uint32_t(pieces.size() - 1));
                tiles.tile.push_back(tile);
                ++tiles.placed[tile];
            };
            if (!thin) return add();
            cut_into_pieces(hair, *ribbon, uint32_t(s), glm::ivec2(x, y) * kViewTile, [&](const RibbonPiece& piece) {
                pieces.push_back(piece);
                add();
            });
        });
    }
}

}  // namespace

TileBins bin_pieces(const HairInView& hair) {
    TileBins bins;
    bins.part.resize(kParts);
    const size_t segments = hair.segments.size();
    std::vector<PartTiles> parts(kParts);
    tbb::parallel_for(size_t(0), kParts, [&](size_t k) {
        bin_part(hair, segments * k / kParts, segments * (k + 1) / kParts, bins.part[k], parts[k]);
    });
    uint64_t total = 0;
    for (size_t tile = 0; tile < size_t(tile_count(hair.view)); ++tile) {
        bins.first.push_back(total);
        for (PartTiles& part : parts) {
            const uint64_t count = part.placed[tile];
            part.placed[tile] = total;
            total += count;
        }
    }
    bins.first.push_back(total);
    bins.name.resize(total);
    tbb::parallel_for(size_t(0), kParts, [&](size_t k) {
        PartTiles& part = parts[k];
        for (size_t i = 0; i < part.tile.size(); ++i)
            bins.name[part.placed[part.tile[i]]++] = {uint32_t(k), part.piece[i]};
        part = {};
    });
    return bins;
}

}  // namespace tress
