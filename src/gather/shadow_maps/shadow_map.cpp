// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/shadow_map.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "gather/shadow_maps/hair_window.h"

namespace tress {
namespace {

/// Light below which a texel of the kinds that know no bound of errors is opaque.
constexpr float kOpaque = 1e-3f;

/// Makes the texels of each tile, then sets them one after the other. `opaque`: as of project_hair.
template <class Texels, class Make>
Texels assemble_tiles(const LightView& view, const SegmentView& segments, const Attenuation& attenuation, float opaque,
                      const Make& make) {
    std::vector<Texels> tiles(size_t(tile_count(view)));
    project_hair(view, segments, attenuation, opaque,
                 [&](int tile, FragmentTile& fragments) { tiles[size_t(tile)] = make(fragments); });
    Texels all;
    for (Texels& tile : tiles) {
        append(all, tile);
        tile = {};
    }
    return all;
}

DepthRange joined(const DepthRange& a, const DepthRange& b) {
    return {std::min(a.nearest, b.nearest), std::max(a.farthest, b.farthest)};
}

/// Depths between which axes of fibers run in the view: of what lies in it of each, since its ends may not.
DepthRange depth_range(const LightView& view, const SegmentView& segments) {
    constexpr size_t kGrain = 8192;  // segments a task: about a millisecond
    constexpr DepthRange kNothing{kInfinity, -kInfinity};
    const ViewRectangle rectangle{view.low, view.low + view.texel * glm::dvec2(view.width, view.height)};
    const DepthRange range = tbb::parallel_reduce(
        tbb::blocked_range<size_t>(0, segments.size(), kGrain), kNothing,
        [&](const tbb::blocked_range<size_t>& part, DepthRange found) {
            for (size_t i = part.begin(); i < part.end(); ++i) {
                const auto inside = clip(in_view(view, segments, i), rectangle, projection_of(view));
                if (!inside) continue;
                for (const DVec3& end : inside->end) {
                    const float depth = float(end.z - view.start);
                    found = joined(found, {depth, depth});
                }
            }
            return found;
        },
        joined);
    return range.nearest <= range.farthest ? range : DepthRange{};
}

/// The four texels about a place and their weights; at the rim the texels outside are those inside next to them.
struct Footprint {
    size_t texel[4];
    float weight[4];
};

Footprint footprint(const LightView& view, const ViewPoint& at) {
    const float x = at.x - 0.5f, y = at.y - 0.5f, x0 = std::floor(x), y0 = std::floor(y);
    const auto inside = [](float texel, int count) { return int(glm::clamp(texel, 0.0f, float(count - 1))); };
    const int left = inside(x0, view.width), right = inside(x0 + 1, view.width);
    const int low = inside(y0, view.height), high = inside(y0 + 1, view.height);
    const float fx = x - x0, fy = y - y0;
    return {{texel_index(view, left, low), texel_index(view, right, low), texel_index(view, left, high),
             texel_index(view, right, high)},
            {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy}};
}

}  // namespace

ShadowMap make_shadow_map(const LightView& view, MapKind kind, const SegmentView& segments,
                          const Attenuation& attenuation, const Options& options) {
    switch (kind) {
        case MapKind::deep:
            return {view, assemble_tiles<DeepTexels>(
                              view, segments, attenuation, least_light(options.deep.error),
                              [&](const FragmentTile& tile) { return make_deep_texels(tile, options.deep.error); })};
        case MapKind::opacity: {
            const DepthRange range = depth_range(view, segments);
            return {view,
                    assemble_tiles<OpacityTexels>(view, segments, attenuation, kOpaque, [&](const FragmentTile& tile) {
                        return make_opacity_texels(tile, options.opacity, range);
                    })};
        }
        case MapKind::clusters:
            break;
    }
    return {view, assemble_tiles<ClusterTexels>(view, segments, attenuation, kOpaque, [&](const FragmentTile& tile) {
                return make_cluster_texels(tile, options.clusters);
            })};
}

Rgb transmittance(const ShadowMap& map, const ViewPoint& at) {
    const Footprint about = footprint(map.view, at);
    return std::visit(
        [&](const auto& texels) {
            Rgb sum(0);
            for (int i = 0; i < 4; ++i) sum += about.weight[i] * transmittance(texels, about.texel[i], at.depth);
            return sum;
        },
        map.texels);
}

float depth_blur(const ShadowMap& map) {
    const auto* layered = std::get_if<OpacityTexels>(&map.texels);
    const bool even = layered && layered->first.empty() && layered->layers > 0;
    return even ? layered->span / float(layered->layers) : 0;
}

size_t bytes(const ShadowMap& map) {
    return std::visit([](const auto& texels) { return bytes(texels); }, map.texels);
}

}  // namespace tress
