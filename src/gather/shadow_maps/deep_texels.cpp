// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/deep_texels.h"

#include <cassert>
#include <limits>
#include <string>

#include "core/error.h"
#include "gather/shadow_maps/step_compression.h"

namespace tress {

namespace {

constexpr float kUnits = std::numeric_limits<uint16_t>::max();

/// Rounds to zero units, by no more than any value may be rounded.
constexpr double kNothing = 0.5 / kUnits;

int channels(const FragmentTile& fragments) { return fragments.opacity[1].empty() ? 1 : 3; }

/// What is left of the light behind each fragment of one texel, up to the first that leaves `least` at most. Returns
/// how many fragments that is.
size_t multiply_up(const FragmentTile& fragments, size_t begin, size_t end, double least,
                   std::vector<float> (&left)[3]) {
    const int n = channels(fragments);
    double light[3] = {1, 1, 1};
    for (int c = 0; c < n; ++c) left[c].resize(end - begin);
    for (size_t i = begin; i < end; ++i) {
        bool some = false;
        for (int c = 0; c < n; ++c) {
            light[c] *= 1 - double(fragments.opacity[c][i]);
            left[c][i - begin] = float(light[c]);
            some |= light[c] > least;
        }
        if (!some) return i + 1 - begin;
    }
    return end - begin;
}

StepFunction step_function(const FragmentTile& fragments, size_t begin, size_t count,
                           const std::vector<float> (&left)[3]) {
    StepFunction steps;
    steps.depth = {fragments.depth.data() + begin, count};
    for (int c = 0; c < channels(fragments); ++c) steps.value[c] = {left[c].data(), count};
    return steps;
}

/// Rounding keeps order, and 0 and 1.
void append_rounded(DeepTexels& to, const StepNodes& nodes) {
    to.depth.insert(to.depth.end(), nodes.depth.begin(), nodes.depth.end());
    for (int c = 0; c < 3; ++c)
        for (const float v : nodes.value[c]) to.value[c].push_back(uint16_t(double(v) * double(kUnits) + 0.5));
}

}  // namespace

void check_node_count(uint64_t nodes) {
    constexpr uint64_t kMost = std::numeric_limits<uint32_t>::max();
    if (nodes > kMost)
        throw InputError("deep shadow map", "needs " + std::to_string(nodes) + " nodes, expected at most " +
                                                std::to_string(kMost) + ": lower maps.resolution or raise deep.error");
}

float least_light(float error) {
    constexpr float kShare = 0.25f;  // more lets fewer fragments do, but leaves less for compression
    return kShare * error;
}

DeepTexels make_deep_texels(const FragmentTile& fragments, float error) {
    const double least = std::max(double(least_light(error)), kNothing);
    const float bound = error - least_light(error);
    DeepTexels texels;
    StepCompressor compress;
    StepNodes nodes;
    std::vector<float> left[3];
    texels.first.reserve(fragments.first.size());
    texels.first.push_back(0);
    for (size_t t = 0; t + 1 < fragments.first.size(); ++t) {
        const size_t begin = fragments.first[t], end = fragments.first[t + 1];
        if (begin < end) {
            const size_t count = multiply_up(fragments, begin, end, least, left);
            compress(step_function(fragments, begin, count, left), bound, nodes);
            append_rounded(texels, nodes);
            check_node_count(texels.depth.size());
        }
        texels.first.push_back(uint32_t(texels.depth.size()));
    }
    return texels;
}

void append(DeepTexels& to, const DeepTexels& tile) {
    const uint64_t before = to.depth.size();
    check_node_count(before + tile.depth.size());
    if (to.first.empty()) to.first.push_back(0);
    for (size_t t = 1; t < tile.first.size(); ++t) to.first.push_back(uint32_t(before + tile.first[t]));
    to.depth.insert(to.depth.end(), tile.depth.begin(), tile.depth.end());
    for (int c = 0; c < 3; ++c) {
        to.value[c].insert(to.value[c].end(), tile.value[c].begin(), tile.value[c].end());
        assert(to.value[c].empty() || to.value[c].size() == to.depth.size());
    }
}

Rgb transmittance(const DeepTexels& texels, size_t texel, float depth) {
    const size_t begin = texels.first[texel], end = texels.first[texel + 1];
    // The first node that is not before `depth`: halves by a choice, not by a jump, since no branch foresees it. What
    // is no number is before all nodes.
    const float* const nodes = texels.depth.data();
    size_t node = begin;
    for (size_t length = end - begin; length > 0;) {
        const size_t half = (length + 1) / 2;
        node += nodes[node + half - 1] < depth ? half : 0;
        length -= half;
    }
    if (node == begin) return Rgb(1);
    const size_t next = node < end ? node : node - 1, last = node - 1;
    const float share = next == last ? 0 : (depth - nodes[last]) / (nodes[next] - nodes[last]);
    const auto value = [&](int c) {
        const float from = texels.value[c][last], to = texels.value[c][next];
        return (from + share * (to - from)) * (1 / kUnits);
    };
    if (texels.value[1].empty()) return Rgb(value(0));
    return {value(0), value(1), value(2)};
}

size_t bytes(const DeepTexels& texels) {
    size_t sum = texels.first.size() * sizeof(uint32_t) + texels.depth.size() * sizeof(float);
    for (const std::vector<uint16_t>& value : texels.value) sum += value.size() * sizeof(uint16_t);
    return sum;
}

}  // namespace tress
