// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/tile_bins.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "gather/shadow_maps/hair_window.h"
#include "gather/shadow_maps/ribbon.h"

namespace tress {
namespace {

/// Parts of the list of segments that are binned each on its own, one after another. Not the number of threads, on
/// which the result would then depend; enough for any.
constexpr size_t kParts = 64;

/// A dot's outline (ribbon.cpp) reaches farther than its radius by 1.3 %, and texels are rounded.
constexpr double kOutline = 1.02;

/// What a part holds: segments in tiles.
struct PartTiles {
    std::vector<uint32_t> segment, tile;  // one a segment in a tile
    std::vector<uint64_t> placed;         // one a tile: how many of it; then where the next goes
};

/// A view and what of its plane its texels cover.
struct TileGrid {
    explicit TileGrid(const LightView& v)
        : view(v), projection(projection_of(v)), whole{v.low, v.low + glm::dvec2(v.width, v.height) * v.texel} {}

    /// Tiles [low, high) that a rectangle touches. A thin ribbon reaches kThin of a texel beyond its axis.
    TexelRect touched_by(const ViewRectangle& r) const {
        const glm::dvec2 low = (r.low - view.low) / view.texel - kThin, high = (r.high - view.low) / view.texel + kThin;
        const glm::dvec2 size(view.width, view.height);
        if (!(low.x < size.x && low.y < size.y && high.x > 0 && high.y > 0)) return {{0, 0}, {0, 0}};
        const glm::ivec2 tiles(tiles_across(view), tiles_down(view));
        return {glm::ivec2(max(low, 0.0)) / kViewTile, min(glm::ivec2(min(high, size)) / kViewTile + 1, tiles)};
    }

    LightView view;
    Projection projection;
    ViewRectangle whole;
};

/// An end of a segment.
struct EndInView {
    uint32_t point;
    DVec3 center;
    double radius;
    ViewRectangle about;  // the ball at the end
};

EndInView end_in_view(const TileGrid& grid, uint32_t point, const Vec3& at, float radius) {
    EndInView end{point, to_local(grid.view, DVec3(at)), kOutline * double(radius), {}};
    end.about = rectangle_about_ball(end.center, end.radius, grid.projection);
    return end;
}

/// A rectangle about what of a segment may lie in the view.
ViewRectangle rectangle_about(const TileGrid& grid, const EndInView& start, const EndInView& end) {
    ViewRectangle r = start.about;
    r.add(end.about);
    if (!r.contains(kEverywhere)) return r;
    // It comes near a pinhole's plane or crosses it.
    const ViewHair hair{{start.center, end.center}, {start.radius, end.radius}};
    const auto part =
        clip(hair, grown(grid.whole, kThin * glm::max(grid.view.texel.x, grid.view.texel.y)), grid.projection);
    return part ? rectangle_of(*part, grid.projection) : ViewRectangle{};
}

void bin_part(const TileGrid& grid, const SegmentView& segments, size_t first, size_t last, PartTiles& part) {
    part.placed.assign(size_t(tile_count(grid.view)), 0);
    const size_t likely = (last - first) * 5 / 4;  // where segments are a few texels long and all are seen
    part.segment.reserve(likely), part.tile.reserve(likely);
    const int across = tiles_across(grid.view);
    EndInView end{};
    for (size_t s = first; s < last; ++s) {
        const uint32_t point = segments.point[s];
        const bool is_linked = s > first && end.point == point;
        const EndInView start = is_linked ? end : end_in_view(grid, point, segments.start(s), segments.start_radius(s));
        end = end_in_view(grid, point + 1, segments.end(s), segments.end_radius(s));
        const TexelRect tiles = grid.touched_by(rectangle_about(grid, start, end));
        for (int y = tiles.low.y; y < tiles.high.y; ++y)
            for (int x = tiles.low.x; x < tiles.high.x; ++x) {
                const uint32_t tile = uint32_t(y * across + x);
                part.segment.push_back(uint32_t(s));
                part.tile.push_back(tile);
                ++part.placed[tile];
            }
    }
}

}  // namespace

TileBins bin_segments(const LightView& view, const SegmentView& segments) {
    const TileGrid grid(view);
    const size_t count = segments.size();
    std::vector<PartTiles> parts(kParts);
    tbb::parallel_for(size_t(0), kParts, [&](size_t k) {
        bin_part(grid, segments, count * k / kParts, count * (k + 1) / kParts, parts[k]);
    });
    TileBins bins;
    uint64_t total = 0;
    for (size_t tile = 0; tile < size_t(tile_count(view)); ++tile) {
        bins.first.push_back(total);
        for (PartTiles& part : parts) {
            const uint64_t placed = part.placed[tile];
            part.placed[tile] = total;
            total += placed;
        }
    }
    bins.first.push_back(total);
    bins.segment.resize(total);
    tbb::parallel_for(size_t(0), kParts, [&](size_t k) {
        PartTiles& part = parts[k];
        for (size_t i = 0; i < part.tile.size(); ++i) bins.segment[part.placed[part.tile[i]]++] = part.segment[i];
        part = {};
    });
    return bins;
}

}  // namespace tress
