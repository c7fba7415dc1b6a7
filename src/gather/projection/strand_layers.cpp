// SPDX-License-Identifier: MIT
#include "gather/projection/strand_layers.h"

#include "core/rng.h"

namespace tress {
namespace {

constexpr uint64_t kKey = hash(0, 0x6c6179657273);
constexpr float kMostLayers = 1 << 20;

uint32_t layer_of(float distance, float depth) { return uint32_t(std::min(distance / depth, kMostLayers)) + 1; }

}  // namespace

StrandLayers make_strand_layers(const SegmentView& segments) {
    StrandLayers layers;
    for (uint32_t i = 0; i < segments.size(); ++i) {
        const bool goes_on = i > 0 && segments.point[i] == segments.point[i - 1] + 1;
        if (goes_on) continue;
        layers.first.push_back(i);
        layers.root.push_back(segments.start(i));
        layers.phase.push_back(random(kKey, i));
    }
    layers.first.push_back(uint32_t(segments.size()));
    return layers;
}

void choose_segments(const StrandLayers& layers, const SegmentView& segments, const ProjectionOptions& options,
                     const Vec3& point, std::vector<ChosenSegment>& chosen) {
    chosen.clear();
    const bool by_root = options.measure == LayerMeasure::root;
    for (size_t strand = 0; strand < layers.root.size(); ++strand) {
        const uint32_t first = layers.first[strand], end = layers.first[strand + 1];
        const float phase = layers.phase[strand];
        const auto choose = [&](uint32_t segment, uint32_t layer) {
            chosen.push_back({segment, options.weighted ? float(layer) : 1});
        };
        if (by_root) {
            const uint32_t layer = layer_of(distance(layers.root[strand], point), options.layer);
            for (uint32_t i = first + uint32_t(phase * float(layer)); i < end; i += layer) choose(i, layer);
            continue;
        }
        for (uint32_t i = first; i < end; ++i) {
            const uint32_t layer = layer_of(distance(segments.start(i), point), options.layer);
            if ((i - first + uint32_t(phase * float(layer))) % layer == 0) choose(i, layer);
        }
    }
}

size_t bytes(const StrandLayers& l) {
    return l.first.capacity() * sizeof(uint32_t) + l.root.capacity() * sizeof(Vec3) +
           l.phase.capacity() * sizeof(float);
}

}  // namespace tress
