// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/tile_pieces.h"

#include <algorithm>

namespace tress {
namespace {

/// Whether all of a rectangle lies outside one edge of a convex outline, or the outline outside one of its own.
bool misses(const RibbonOutline& o, const TexelRect& rect) {
    const glm::dvec2 low(rect.low), high(rect.high), middle = 0.5 * (low + high), half = 0.5 * (high - low);
    glm::dvec2 least(o.corner[0]), most(o.corner[0]);
    double area = 0;
    for (int k = 0; k < o.corners; ++k) {
        const glm::dvec2 p = o.corner[size_t(k)], q = o.corner[size_t((k + 1) % o.corners)];
        area += p.x * q.y - p.y * q.x;
        least = min(least, p), most = max(most, p);
    }
    if (!(least.x < high.x && least.y < high.y && most.x > low.x && most.y > low.y)) return true;
    for (int k = 0; k < o.corners; ++k) {
        const glm::dvec2 p = o.corner[size_t(k)];
        const glm::dvec2 edge = o.corner[size_t((k + 1) % o.corners)] - p, from = middle - p;
        const double inward = (area < 0 ? -1 : 1) * (edge.x * from.y - edge.y * from.x);
        if (inward < -(half.y * std::abs(edge.x) + half.x * std::abs(edge.y))) return true;
    }
    return false;
}

/// Whether a thin ribbon is outside texels [low, high) of its minor axis between two places of its major axis, along
/// which it takes shares `from` to `to` of it.
bool misses(const Ribbon& r, double from, double to, double low, double high) {
    const int minor = 1 - r.major;
    const double start = r.at[0][minor], rise = r.at[1][minor] - start;
    const double a = start + from * rise, b = start + to * rise;
    const double width = std::max(r.half_width[0], r.half_width[1]);
    return !(std::min(a, b) - width < high && std::max(a, b) + width > low);
}

/// At columns of texels.
void cut_ribbon(const HairInView& hair, const Ribbon& r, uint32_t segment, const TexelRect& rect,
                std::vector<RibbonPiece>& pieces) {
    const int major = r.major, minor = 1 - major;
    const double from = std::max(r.at[0][major], double(rect.low[major]));
    const double to = std::min(r.at[1][major], double(rect.high[major]));
    if (!(from < to)) return;
    const double scale = 1 / (r.at[1][major] - r.at[0][major]);
    for (int first = int(from); first < to; first += kPieceTexels) {
        const double low = std::max(from, double(first)), high = std::min(to, double(first + kPieceTexels));
        const double u = (low - r.at[0][major]) * scale, v = (high - r.at[0][major]) * scale;
        if (misses(r, u, v, rect.low[minor], rect.high[minor])) continue;
        RibbonPiece& piece = pieces.emplace_back(cut_thin(hair.view, r, low, high, rect.low));
        piece.segment = segment;
        piece.stopped = stopped_light(hair, r, segment, r.at[0] + 0.5 * (u + v) * (r.at[1] - r.at[0]));
    }
}

}  // namespace

void cut_into_pieces(const HairInView& hair, std::span<const uint32_t> segments, const TexelRect& rect,
                     std::vector<RibbonPiece>& pieces) {
    pieces.clear();
    for (const uint32_t segment : segments) {
        const std::optional<Ribbon> ribbon = make_ribbon(hair.view, hair.segments, segment);
        if (!ribbon) continue;
        if (ribbon->shape == Ribbon::Shape::thin)
            cut_ribbon(hair, *ribbon, segment, rect, pieces);
        else if (!misses(outline(hair.view, *ribbon), rect))
            pieces.push_back(whole_piece(hair.view, *ribbon, segment));
    }
}

}  // namespace tress
