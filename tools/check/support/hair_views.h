// SPDX-License-Identifier: MIT
// Views, absorptions and fragments to try the projection of hair on.
#pragma once

#include <vector>

#include "gather/shadow_maps/hair_fragments.h"
#include "tools/check/support/tree_scenes.h"

namespace tress::fragments {

using scenes::Dice;
using scenes::Hair;

/// A view along a random direction through the point `middle`, of `size` texels a side.
inline LightView random_view(Dice& dice, bool parallel, const Vec3& middle, double distance, double texel, int size) {
    LightView view;
    view.parallel = parallel;
    view.frame = frame_about(dice.direction());
    view.origin = DVec3(middle) - distance * DVec3(view.frame.z);
    view.start = 0.25 * distance;
    view.width = view.height = size;
    view.texel = glm::dvec2(texel, texel * (0.7 + 0.6 * double(dice.unit()))) / (parallel ? 1 : distance);
    view.low = -0.5 * double(size) * view.texel;
    return view;
}

/// One fiber that stops as much at any inclination.
inline Attenuation constant_attenuation(const Rgb& depth) {
    AttenuationTable table;
    table.depth.assign(AttenuationTable::kRows, depth);
    return {{table}, {}, {}, {}};
}
/// Stops everything: opacity is coverage.
inline Attenuation opaque() { return constant_attenuation(Rgb(kOpaqueDepth)); }

/// Stops more the more it is inclined, each channel in its way.
inline Attenuation inclined_attenuation(const Rgb& depth) {
    Attenuation a = constant_attenuation(depth);
    for (size_t row = 0; row < a.table[0].depth.size(); ++row)
        a.table[0].depth[row] *= 2 - float(row) / float(AttenuationTable::kRows - 1);
    return a;
}

/// Fragments of a whole view; those of a texel as texel_index counts.
struct ViewFragments {
    std::vector<FragmentTile> tiles;

    struct Range {
        const FragmentTile& tile;
        uint32_t first, last;
    };
    Range of(const LightView& view, int x, int y) const {
        constexpr size_t kTexels = size_t(kViewTile) * kViewTile;
        const size_t index = texel_index(view, x, y);
        const FragmentTile& tile = tiles[index / kTexels];
        return {tile, tile.first[index % kTexels], tile.first[index % kTexels + 1]};
    }
    size_t size() const {
        size_t n = 0;
        for (const FragmentTile& tile : tiles) n += tile.depth.size();
        return n;
    }
};
inline constexpr float kOpaque = 1e-4f;
inline ViewFragments project_all(const LightView& view, const SegmentView& segments, const Attenuation& attenuation) {
    ViewFragments all;
    all.tiles.resize(size_t(tile_count(view)));
    project_hair(view, segments, attenuation, kOpaque,
                 [&](int tile, FragmentTile& fragments) { all.tiles[size_t(tile)] = fragments; });
    return all;
}

/// The way of the light through a place of the view, texels, in double.
inline DVec3 light_through(const LightView& view, const glm::dvec2& place) {
    if (view.parallel) return DVec3(view.frame.z);
    const glm::dvec2 at = view.low + place * view.texel;
    return at.x * DVec3(view.frame.x) + at.y * DVec3(view.frame.y) + DVec3(view.frame.z);
}
/// Where that light starts.
inline DVec3 light_origin(const LightView& view, const glm::dvec2& place) {
    if (!view.parallel) return view.origin;
    const glm::dvec2 at = view.low + place * view.texel;
    return view.origin + at.x * DVec3(view.frame.x) + at.y * DVec3(view.frame.y);
}

/// What must hold whatever is projected: tiles are whole, depths in order, opacities in [0, 1], channels all or one.
inline bool is_sound(const FragmentTile& tile, int channels) {
    constexpr size_t kTexels = size_t(kViewTile) * kViewTile;
    if (tile.first.size() != kTexels + 1 || tile.first[0] != 0 || tile.first[kTexels] != tile.depth.size())
        return false;
    for (size_t i = 0; i < kTexels; ++i) {
        if (tile.first[i] > tile.first[i + 1]) return false;
        for (uint32_t k = tile.first[i]; k < tile.first[i + 1]; ++k) {
            if (!std::isfinite(tile.depth[k])) return false;
            if (k > tile.first[i] && !(tile.depth[k - 1] <= tile.depth[k])) return false;
        }
    }
    for (int c = 0; c < 3; ++c) {
        if (tile.opacity[c].size() != (c < channels ? tile.depth.size() : 0)) return false;
        for (const float opacity : tile.opacity[c])
            if (!(opacity >= 0 && opacity <= 1)) return false;
    }
    return true;
}

}  // namespace tress::fragments
