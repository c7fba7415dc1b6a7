// SPDX-License-Identifier: MIT
// Clustered densities (Mertens et al. 2004): the hair of a texel as a few clusters along the light, found by k-means;
// each is a slab of even density about its mean depth, with the variance of its fragments.
#pragma once

#include <vector>

#include "core/math.h"
#include "core/options.h"
#include "gather/shadow_maps/hair_fragments.h"
#include "gather/shadow_maps/texel_rows.h"

namespace tress {

/// Cluster k of row r is at r * clusters + k, in the order of depth; one with no hair has optical depth 0. Fragments
/// weigh as much as their optical depth, mean over channels. An even slab of variance s * s is sqrt(3) s wide to either
/// side; it may begin before the first of its fragments. Light is lost behind `mean` where the half width is 0.
struct ClusterTexels {
    int clusters = 0;
    TexelRows rows;                       // of the texels
    std::vector<float> mean, half_width;  // of the slab, scene units
    std::vector<float> depth[3];  // optical depth of the whole cluster; one channel where no fiber colours light
};

/// The best clusters there are (cluster_runs.h); as many as there are different depths, at most.
ClusterTexels make_cluster_texels(const FragmentTile& fragments, const ClusterOptions& options);

/// `tile` must have been made with the same options. Onto a default-made `to`, a copy.
void append(ClusterTexels& to, const ClusterTexels& tile);

/// 1 for a depth that is no number.
Rgb transmittance(const ClusterTexels& texels, size_t texel, float depth);

size_t bytes(const ClusterTexels& texels);

}  // namespace tress
