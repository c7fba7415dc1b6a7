// SPDX-License-Identifier: MIT
// Deep shadow maps (Lokovic & Veach 2000): a texel holds what is left of the light as a function of depth, piecewise
// linear, compressed so that it errs nowhere by more than a bound.
#pragma once

#include <cstdint>
#include <vector>

#include "core/math.h"
#include "gather/shadow_maps/hair_fragments.h"

namespace tress {

/// Nodes of texel i are first[i] .. first[i + 1] - 1: from (depth of its first hair, 1) on, linear between nodes, then
/// constant. Two nodes at one depth are a step. No node: no hair.
struct DeepTexels {
    std::vector<uint32_t> first;     // one a texel (texel_index), and one past the end
    std::vector<float> depth;        // one a node
    std::vector<uint16_t> value[3];  // of 65535; one channel, the others empty, where no fiber colours light
};

/// Light down to which a texel is followed: what is left out behind comes out of the error that is allowed.
float least_light(float error);

/// Texels of one tile. `error`: greatest absolute error of a value, of each channel. Half a unit of 16 bits, 1 /
/// 131070, comes on top of it by rounding, and as much again behind a hair where no channel has more than that left:
/// what is farther is left out.
DeepTexels make_deep_texels(const FragmentTile& fragments, float error);

/// Appends the texels of one tile to those of the tiles before it. Throws InputError past 2^32 - 1 nodes.
void append(DeepTexels& to, const DeepTexels& tile);

/// At one depth with hair the light before it.
Rgb transmittance(const DeepTexels& texels, size_t texel, float depth);

size_t bytes(const DeepTexels& texels);

/// Throws InputError where that many nodes of a map cannot be indexed.
void check_node_count(uint64_t nodes);

}  // namespace tress
