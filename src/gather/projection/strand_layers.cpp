// SPDX-License-Identifier: MIT
#include "gather/projection/strand_layers.h"

#include "core/rng.h"

namespace tress {
namespace {

constexpr uint64_t kKey = hash(0, 0x6c6179657273);
constexpr float kMostLayers = 1 << 20;
constexpr float kEdge = 0.2f;  // of a layer: strands change layers there one by one, so that no edge is seen

/// `shift`: the strand's own, in [0, 1).
uint32_t layer_of(float distance, float depth, float shift) {
    const float layers = std::min(distance / depth, kMostLayers) + kEdge * (shift - 0.5f);
    return uint32_t(std::max(layers, 0.0f)) + 1;
}

}  // namespace

StrandLayers make_strand_layers(const SegmentView& segments) {
    StrandLayers layers;
    for (uint32_t i = 0; i < segments.size(); ++i) {
        if (i > 0 && joined(segments, i - 1, i)) continue;
        layers.first.push_back(i);
        layers.root.push_back(segments.start(i));
        layers.phase.push_back(random(kKey, i));
        layers.shift.push_back(random(hash(kKey, 1), i));
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
        const float phase = layers.phase[strand], shift = layers.shift[strand];
        const auto choose = [&](uint32_t segment, uint32_t layer) {
            chosen.push_back({segment, options.weighted ? float(layer) : 1});
        };
        if (by_root) {
            const uint32_t layer = layer_of(distance(layers.root[strand], point), options.layer, shift);
            for (uint32_t i = first + uint32_t(phase * float(layer)); i < end; i += layer) choose(i, layer);
            continue;
        }
        for (uint32_t i = first; i < end; ++i) {
            const uint32_t layer = layer_of(distance(segments.start(i), point), options.layer, shift);
            if ((i - first + uint32_t(phase * float(layer))) % layer == 0) choose(i, layer);
        }
    }
}

size_t bytes(const StrandLayers& l) {
    return l.first.capacity() * sizeof(uint32_t) + l.root.capacity() * sizeof(Vec3) +
           (l.phase.capacity() + l.shift.capacity()) * sizeof(float);
}

}  // namespace tress
