// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/cluster_texels.h"

#include "gather/shadow_maps/cluster_runs.h"
#include "gather/shadow_maps/optical_depth.h"

namespace tress {
namespace {

/// Points of one texel, with the optical depth of each channel.
struct TexelPoints {
    WeightedDepths points;
    std::vector<double> depth[3];
};

void add_point(TexelPoints& texel, double place, const double (&depth)[3], int channels) {
    double sum = 0;
    for (int channel = 0; channel < channels; ++channel) sum += depth[channel];
    if (!(sum > 0)) return;
    WeightedDepths& points = texel.points;
    const bool is_new = points.depth.empty() || points.depth.back() < place;
    if (is_new) {
        points.depth.push_back(place);
        points.weight.push_back(0);
        for (int channel = 0; channel < channels; ++channel) texel.depth[channel].push_back(0);
    }
    points.weight.back() += sum / channels;
    for (int channel = 0; channel < channels; ++channel) texel.depth[channel].back() += depth[channel];
}

/// Fragments [begin, end) as points: those of one depth together, those that stop nothing left out.
void gather_points(const FragmentTile& fragments, size_t begin, size_t end, TexelPoints& texel) {
    texel.points.depth.clear();
    texel.points.weight.clear();
    for (std::vector<double>& depth : texel.depth) depth.clear();
    const int channels = fragments.opacity[1].empty() ? 1 : 3;
    for (size_t k = begin; k < end; ++k) {
        double depth[3] = {};
        for (int channel = 0; channel < channels; ++channel)
            depth[channel] = double(optical_depth(fragments.opacity[channel][k]));
        add_point(texel, double(fragments.depth[k]), depth, channels);
    }
}

struct Slab {
    double mean = 0, half_width = 0;
};

/// Of the points [begin, end). Moments about the first of them: points at one depth give that depth and no width.
Slab slab_of(const WeightedDepths& points, size_t begin, size_t end) {
    double weight = 0, first = 0, second = 0;
    for (size_t k = begin; k < end; ++k) {
        weight += points.weight[k];
        first += points.weight[k] * (points.depth[k] - points.depth[begin]);
    }
    const double mean = points.depth[begin] + first / weight;
    for (size_t k = begin; k < end; ++k) second += points.weight[k] * square(points.depth[k] - mean);
    return {mean, std::sqrt(3 * second / weight)};
}

void add_row(ClusterTexels& texels, const TexelPoints& texel, std::span<const uint32_t> ends) {
    Slab slab;
    for (size_t cluster = 0, begin = 0; cluster < size_t(texels.clusters); ++cluster) {
        const size_t end = cluster < ends.size() ? ends[cluster] : begin;
        if (begin < end) slab = slab_of(texel.points, begin, end);
        texels.mean.push_back(float(slab.mean));
        texels.half_width.push_back(float(slab.half_width));
        for (int channel = 0; channel < 3 && !texel.depth[channel].empty(); ++channel) {
            double sum = 0;
            for (size_t k = begin; k < end; ++k) sum += texel.depth[channel][k];
            texels.depth[channel].push_back(float(sum));
        }
        begin = end;
    }
}

/// Share of a slab that lies before `depth`. A width of 0 is a step: 0 / 0 at its place, which is no number, as a depth
/// may be, and counts as before.
float share_before(float mean, float half_width, float depth) {
    const float share = (depth - mean) / (2 * half_width) + 0.5f;
    return share > 0 ? glm::min(share, 1.0f) : 0;
}

template <int channels>
Rgb depth_before(const ClusterTexels& texels, uint32_t row, float depth) {
    const size_t begin = size_t(row) * size_t(texels.clusters);
    Rgb sum(0);
    for (size_t k = begin; k < begin + size_t(texels.clusters); ++k) {
        const float share = share_before(texels.mean[k], texels.half_width[k], depth);
        for (int channel = 0; channel < channels; ++channel) sum[channel] += share * texels.depth[channel][k];
    }
    return sum;
}

}  // namespace

ClusterTexels make_cluster_texels(const FragmentTile& fragments, const ClusterOptions& options) {
    ClusterTexels texels;
    texels.clusters = options.count;
    TexelPoints texel;
    ClusterRuns runs;
    for (size_t k = 0; k + 1 < fragments.first.size(); ++k) {
        gather_points(fragments, fragments.first[k], fragments.first[k + 1], texel);
        const bool has_hair = !texel.points.depth.empty();
        add_texel(texels.rows, has_hair);
        if (!has_hair) continue;
        best_runs(texel.points, options.count, runs);
        add_row(texels, texel, runs.end);
    }
    return texels;
}

void append(ClusterTexels& to, const ClusterTexels& tile) {
    to.clusters = tile.clusters;
    append(to.rows, tile.rows);
    append(to.mean, tile.mean);
    append(to.half_width, tile.half_width);
    for (int channel = 0; channel < 3; ++channel) append(to.depth[channel], tile.depth[channel]);
}

Rgb transmittance(const ClusterTexels& texels, size_t texel, float depth) {
    const uint32_t row = texels.rows.row[texel];
    if (row == TexelRows::kNone) return Rgb(1);
    if (texels.depth[1].empty()) return Rgb(std::exp(-depth_before<1>(texels, row, depth).x));
    const Rgb sum = depth_before<3>(texels, row, depth);
    return {std::exp(-sum.x), std::exp(-sum.y), std::exp(-sum.z)};
}

size_t bytes(const ClusterTexels& texels) {
    size_t sum = bytes(texels.rows.row) + bytes(texels.mean) + bytes(texels.half_width);
    for (const std::vector<float>& depth : texels.depth) sum += bytes(depth);
    return sum;
}

}  // namespace tress
