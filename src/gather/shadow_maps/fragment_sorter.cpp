// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/fragment_sorter.h"

#include <algorithm>
#include <bit>

#include "core/error.h"

namespace tress {
namespace {

constexpr uint32_t kSign = 0x80000000u;

/// Bits of a float as a number that grows with it: those of a negative one all turned round; -0 is 0.
uint32_t ordered(float value) {
    const uint32_t bits = std::bit_cast<uint32_t>(value + 0.0f);
    return bits ^ (bits & kSign ? ~0u : kSign);
}
float from_ordered(uint32_t number) { return std::bit_cast<float>(number ^ (number & kSign ? kSign : ~0u)); }

}  // namespace

void FragmentSorter::begin(int channels, size_t pieces, float opaque) {
    channels_ = channels;
    opaque_ = opaque;
    stopped_.resize(pieces);
    added_ = 0;
    texels_.assign(kTexels, Texel{1, -kInfinity, kInfinity, 0});
}

void FragmentSorter::begin_piece(uint32_t piece, const Rgb& stopped, size_t most) {
    piece_ = piece;
    stopped_[piece] = stopped;
    least_stopped_ = channels_ == 1 ? stopped.x : min_component(stopped);
    if (added_ + most <= unsorted_.size()) return;
    const size_t size = std::max(2 * unsorted_.size(), added_ + most);
    unsorted_.resize(size), texel_of_.resize(size);
}

void FragmentSorter::add(int index, float coverage, float depth) {
    Texel& texel = texels_[size_t(index)];
    if (depth > texel.closed) return;
    texel.light *= 1 - coverage * least_stopped_;
    texel.deepest = std::max(texel.deepest, depth);
    if (texel.light < opaque_ && texel.closed == kInfinity) texel.closed = texel.deepest;
    ++texel.count;
    unsorted_[added_] = {piece_, ordered(depth), coverage};
    texel_of_[added_] = uint16_t(index);
    ++added_;
}

/// By insertion, which is quick as long as little has to move; else in the usual way.
void FragmentSorter::sort(uint32_t first, uint32_t last) {
    constexpr int64_t kMovesEach = 16;
    int64_t moves = kMovesEach * int64_t(last - first);
    Fragment* f = sorted_.data();
    for (uint32_t i = first + 1; i < last; ++i) {
        const Fragment fragment = f[i];
        const uint64_t order = fragment.order();
        uint32_t to = i;
        for (; to > first && order < f[to - 1].order(); --to) f[to] = f[to - 1];
        f[to] = fragment;
        moves -= i - to;
        if (moves >= 0) continue;
        std::sort(f + first, f + last, [](const Fragment& a, const Fragment& b) { return a.order() < b.order(); });
        return;
    }
}

void FragmentSorter::finish(FragmentTile& tile) {
    if (added_ > 0xffffffffu) throw InputError("shadow map", "more than 2^32 - 1 hair fragments in one tile");
    tile.first.resize(kTexels + 1);
    uint32_t total = 0;
    for (size_t i = 0; i < kTexels; ++i) {
        tile.first[i] = total;
        total += texels_[i].count;
        texels_[i].count = tile.first[i];  // where its next goes
    }
    tile.first[kTexels] = total;

    sorted_.resize(std::max(sorted_.size(), added_));
    for (size_t i = 0; i < added_; ++i) sorted_[texels_[texel_of_[i]].count++] = unsorted_[i];

    tile.depth.resize(added_);
    for (int c = 0; c < 3; ++c) tile.opacity[c].resize(c < channels_ ? added_ : 0);
    for (size_t i = 0; i < kTexels; ++i) {
        sort(tile.first[i], tile.first[i + 1]);
        for (uint32_t k = tile.first[i]; k < tile.first[i + 1]; ++k) {
            const Fragment& f = sorted_[k];
            tile.depth[k] = from_ordered(f.depth);
            const Rgb opacity = min(f.coverage * stopped_[f.piece], Rgb(1));
            for (int c = 0; c < channels_; ++c) tile.opacity[c][k] = opacity[c];
        }
    }
}

}  // namespace tress
