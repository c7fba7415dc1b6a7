// SPDX-License-Identifier: MIT
// Clustered densities (Mertens et al. 2004): the hair of a texel as a few clusters along the light, found by k-means;
// each is a slab of even density about its mean depth, with the variance of its fragments.
#pragma once

#include <vector>

#include "core/math.h"
#include "core/options.h"
#include "gather/shadow_maps/hair_fragments.h"

namespace tress {

/// Cluster k of texel i is row i * clusters + k, in the order of depth; one with no hair has optical depth 0.
struct ClusterTexels {
    int clusters = 0;
    std::vector<float> mean, half_width;  // of the slab, scene units; a half width of 0 is a step
    std::vector<float> depth[3];  // optical depth of the whole cluster; one channel where no fiber colours light
};

ClusterTexels make_cluster_texels(const FragmentTile& fragments, const ClusterOptions& options);
void append(ClusterTexels& to, const ClusterTexels& tile);
Rgb transmittance(const ClusterTexels& texels, size_t texel, float depth);
size_t bytes(const ClusterTexels& texels);

}  // namespace tress
