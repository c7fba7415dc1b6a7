// SPDX-License-Identifier: MIT
#include "gather/shadow_maps/fragment_sorter.h"

#include <algorithm>

#include "core/error.h"

namespace tress {

void FragmentSorter::begin(int channels) {
    channels_ = channels;
    added_ = 0;
    texels_.assign(kTexels, Texel{1, -kInfinity, kInfinity, 0});
}

void FragmentSorter::begin_piece(uint32_t piece, const RibbonPiece& its, size_t most) {
    piece_ = piece;
    least_stopped_ = channels_ == 1 ? its.stopped.x : min_component(its.stopped);
    if (added_ + most <= unsorted_.size()) return;
    const size_t size = std::max(2 * unsorted_.size(), added_ + most);
    unsorted_.resize(size), texel_of_.resize(size);
}

void FragmentSorter::add(int index, float coverage, float depth) {
    Texel& texel = texels_[size_t(index)];
    if (depth > texel.closed) return;
    texel.light *= 1 - coverage * least_stopped_;
    texel.deepest = std::max(texel.deepest, depth);
    if (texel.light < kOpaqueTexel && texel.closed == kInfinity) texel.closed = texel.deepest;
    ++texel.count;
    unsorted_[added_] = {depth, piece_, coverage};
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
        uint32_t to = i;
        for (; to > first && comes_before(fragment, f[to - 1]); --to) f[to] = f[to - 1];
        f[to] = fragment;
        moves -= i - to;
        if (moves >= 0) continue;
        std::sort(f + first, f + last, comes_before);
        return;
    }
}

void FragmentSorter::finish(std::span<const RibbonPiece> pieces, FragmentTile& tile) {
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
    for (size_t i = 0; i < kTexels; ++i) sort(tile.first[i], tile.first[i + 1]);

    tile.depth.resize(added_);
    for (size_t i = 0; i < added_; ++i) tile.depth[i] = sorted_[i].depth;
    for (int c = 0; c < 3; ++c) {
        std::vector<float>& opacity = tile.opacity[c];
        opacity.resize(c < channels_ ? added_ : 0);
        for (size_t i = 0; i < opacity.size(); ++i)
            opacity[i] = std::min(sorted_[i].coverage * pieces[sorted_[i].piece].stopped[c], 1.0f);
    }
}

}  // namespace tress
