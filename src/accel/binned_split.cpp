// SPDX-License-Identifier: MIT
#include "accel/binned_split.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace tress {
namespace {

constexpr int kMaxBins = 256;  // the range of the option
constexpr uint32_t kFaces = 6;
constexpr size_t kParallelSize = 65536;  // references; below, a task costs more than it saves
constexpr size_t kGrain = 16384;

/// Where the bins lie, for the six faces lo.x, lo.y, lo.z, hi.x, hi.y, hi.z.
struct Grid {
    Vec3 lo, step;
    std::array<float, kFaces> base, scale;

    Grid(const Bounds& cell, int bins) : lo(cell.lo), step(cell.extent() / float(bins)) {
        for (uint32_t k = 0; k < kFaces; ++k) {
            base[k] = cell.lo[int(k % 3)];
            const float inverse = 1 / step[int(k % 3)];
            scale[k] = std::isfinite(inverse) ? inverse : 0;  // a cell too thin for bins is not cut across them
        }
    }
};

/// Faces counted: count[kFaces * bin + face]. The bin past the last holds faces that rounding put there.
struct Counts {
    std::array<uint32_t, kFaces*(kMaxBins + 1)> count;

    void clear(int bins) { std::fill_n(count.begin(), kFaces * size_t(bins + 1), 0u); }
    void add(const Counts& other, int bins) {
        for (size_t i = 0; i < kFaces * size_t(bins + 1); ++i) count[i] += other.count[i];
    }
};

void count_faces(std::span<const Reference> references, const Grid& grid, Counts& even, Counts& odd) {
    const auto count = [&grid](const Reference& r, Counts& counts) {
        const std::array<float, kFaces> face{r.lo.x, r.lo.y, r.lo.z, r.hi.x, r.hi.y, r.hi.z};
        for (uint32_t k = 0; k < kFaces; ++k) {
            const int32_t bin = int32_t((face[k] - grid.base[k]) * grid.scale[k]);
            ++counts.count[size_t(bin * int32_t(kFaces)) + k];
        }
    };
    // Two tables by turns: neighbours often fall into the same bin, and an increment waits for the one before.
    size_t i = 0;
    for (; i + 1 < references.size(); i += 2) {
        count(references[i], even);
        count(references[i + 1], odd);
    }
    if (i < references.size()) count(references[i], even);
}

void count_all(std::span<const Reference> references, const Grid& grid, int bins, Counts& total) {
    total.clear(bins);
    Counts odd;
    odd.clear(bins);
    if (references.size() < kParallelSize) {
        count_faces(references, grid, total, odd);
    } else {
        Counts zero;
        zero.clear(bins);
        tbb::enumerable_thread_specific<Counts> partial(zero);
        tbb::parallel_for(tbb::blocked_range<size_t>(0, references.size(), kGrain), [&](const auto& range) {
            Counts& counts = partial.local();
            count_faces(references.subspan(range.begin(), range.size()), grid, counts, counts);
        });
        for (const Counts& counts : partial) total.add(counts, bins);
    }
    total.add(odd, bins);
}

/// Candidates across one axis: first all counts, then all costs, then the least.
void sweep_planes(const Counts& counts, int bins, const Grid& grid, size_t references, const AxisCost& cost,
                  uint32_t axis, std::optional<Split>& best) {
    std::array<float, kMaxBins> left, right, position, costs;
    uint32_t begun = 0, ended = 0;
    const size_t planes = size_t(bins) - 1;
    for (size_t k = 0; k < planes; ++k) {
        begun += counts.count[kFaces * k + axis];
        ended += counts.count[kFaces * k + 3 + axis];
        left[k] = float(begun);
        right[k] = float(references - ended);
    }
    const float lo = grid.lo[int(axis)], step = grid.step[int(axis)];
    for (size_t k = 0; k < planes; ++k) {
        position[k] = lo + float(int(k) + 1) * step;
        costs[k] = cost(position[k], left[k], right[k]);
    }
    for (size_t k = 0; k < planes; ++k)
        if ((!best || costs[k] < best->cost) && cost.cuts(position[k]))
            best = Split{axis, position[k], costs[k], uint32_t(left[k]), uint32_t(right[k])};
}

}  // namespace

std::optional<Split> binned_split(std::span<const Reference> references, const Bounds& cell,
                                  const AccelOptions& options) {
    const int bins = std::min(options.bins, kMaxBins);
    const Grid grid(cell, bins);
    Counts counts;
    count_all(references, grid, bins, counts);
    std::optional<Split> best;
    for (uint32_t axis = 0; axis < 3; ++axis)
        if (grid.scale[axis] != 0)
            sweep_planes(counts, bins, grid, references.size(), AxisCost(options, cell, axis), axis, best);
    return best;
}

}  // namespace tress
