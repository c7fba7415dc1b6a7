// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/opacity_texels.h"

#include <algorithm>
#include <span>

#include "gather/shadow_maps/optical_depth.h"

namespace tress {
namespace {

struct LayerPlace {
    int layer;
    float fraction;  // of the layer that lies before the place
};

/// Fragments and look-ups go by the same rule, so that rounding cannot part them. No depth is out of place: what lies
/// outside the layers falls on their ends, what is no number on the start. A span of 0 is a step behind `start`.
LayerPlace layer_place(const OpacityTexels& texels, float start, float depth) {
    const float along = (depth - start) / texels.span;
    const float part = along > 0 ? glm::min(along, 1.0f) : 0;
    // Layers that grow as 1 : 3 : 5 ... end at squares: l * l of layers * layers.
    const float position = (texels.first.empty() ? part : std::sqrt(part)) * float(texels.layers);
    const int layer = glm::min(int(position), texels.layers - 1);
    return {layer, position - float(layer)};
}

/// Adds the row of one channel; `place` is the layer of every fragment.
void add_levels(OpacityTexels& texels, int channel, std::span<const int> place, const float* opacity,
                std::vector<double>& sums) {
    sums.assign(size_t(texels.layers), 0);
    for (size_t k = 0; k < place.size(); ++k) sums[size_t(place[k])] += double(optical_depth(opacity[k]));
    double sum = 0;
    for (double& layer : sums) layer = sum = std::min(sum + layer, double(kOpaqueDepth));
    texels.total[channel].push_back(float(sum));
    const double levels_per_depth = sum > 0 ? texels.kFullLevel / sum : 0;
    for (const double before : sums) texels.level[channel].push_back(uint16_t(before * levels_per_depth + 0.5));
}

}  // namespace

OpacityTexels make_opacity_texels(const FragmentTile& fragments, const OpacityOptions& options,
                                  const DepthRange& range) {
    OpacityTexels texels;
    texels.layers = options.layers;
    texels.span = glm::max(range.farthest - range.nearest, 0.0f);
    texels.start = range.nearest;
    std::vector<int> place;
    std::vector<double> sums;
    for (size_t texel = 0; texel + 1 < fragments.first.size(); ++texel) {
        const size_t begin = fragments.first[texel], end = fragments.first[texel + 1];
        add_texel(texels.rows, begin < end);
        if (begin == end) continue;
        if (options.follow) texels.first.push_back(fragments.depth[begin]);
        const float start = options.follow ? fragments.depth[begin] : texels.start;
        place.clear();
        for (size_t k = begin; k < end; ++k) place.push_back(layer_place(texels, start, fragments.depth[k]).layer);
        for (int channel = 0; channel < 3 && !fragments.opacity[channel].empty(); ++channel)
            add_levels(texels, channel, place, &fragments.opacity[channel][begin], sums);
    }
    return texels;
}

void append(OpacityTexels& to, const OpacityTexels& tile) {
    to.layers = tile.layers;
    to.span = tile.span;
    to.start = tile.start;
    append(to.rows, tile.rows);
    append(to.first, tile.first);
    for (int channel = 0; channel < 3; ++channel) {
        append(to.total[channel], tile.total[channel]);
        append(to.level[channel], tile.level[channel]);
    }
}

Rgb transmittance(const OpacityTexels& texels, size_t texel, float depth) {
    const uint32_t row = texels.rows.row[texel];
    if (row == TexelRows::kNone) return Rgb(1);
    const LayerPlace place = layer_place(texels, texels.first.empty() ? texels.start : texels.first[row], depth);
    const auto channel = [&](int c) {
        const uint16_t* level = &texels.level[c][size_t(row) * size_t(texels.layers) + size_t(place.layer)];
        const float before = place.layer > 0 ? float(level[-1]) : 0;
        const float reached = before + place.fraction * (float(level[0]) - before);
        return std::exp(-reached * (texels.total[c][row] / float(texels.kFullLevel)));
    };
    const float red = channel(0);
    if (texels.level[1].empty()) return Rgb(red);
    const float green = channel(1);
    const float blue = channel(2);
    return {red, green, blue};
}

size_t bytes(const OpacityTexels& texels) {
    size_t sum = bytes(texels.rows.row) + bytes(texels.first);
    for (int channel = 0; channel < 3; ++channel) sum += bytes(texels.total[channel]) + bytes(texels.level[channel]);
    return sum;
}

}  // namespace tress
