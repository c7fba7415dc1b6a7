// SPDX-License-Identifier: MIT
#include "accel/binned_split.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cstring>

namespace tress {
namespace {

constexpr int kMaxBins = 256;            // the range of the option
constexpr uint32_t kFaces = 8;           // of a bin, see Grid
constexpr size_t kParallelSize = 65536;  // references; below, a task costs more than it saves
constexpr size_t kGrain = 16384;

/// Where the bins lie, for the eight floats (lo.x, lo.y, lo.z, hi.x, lo.z, hi.x, hi.y, hi.z) that two loads of four
/// bring in from a reference. Numbers 3 and 4 are there twice and not counted.
struct Grid {
    Vec3 lo, step;
    std::array<float, kFaces> base, scale;

    Grid(const Bounds& cell, int bins) : lo(cell.lo) {
        step = cell.extent() / float(bins);
        constexpr int kAxis[kFaces] = {0, 1, 2, 0, 2, 0, 1, 2};
        for (uint32_t k = 0; k < kFaces; ++k) {
            base[k] = cell.lo[kAxis[k]];
            // A cell too thin to be cut in bins gets none.
            const float inverse = 1 / step[kAxis[k]];
            scale[k] = std::isfinite(inverse) ? inverse : 0;
        }
    }
};

/// Faces counted: count[kFaces * bin + number]. The bin past the last holds faces that rounding put there.
struct Counts {
    std::array<uint32_t, kFaces*(kMaxBins + 1)> count;

    void clear(int bins) { std::memset(count.data(), 0, sizeof(uint32_t) * kFaces * size_t(bins + 1)); }
    void add(const Counts& other, int bins) {
        for (size_t i = 0; i < kFaces * size_t(bins + 1); ++i) count[i] += other.count[i];
    }
};

/// Bins of the eight faces of each reference, as indices of Counts. In passes of its own over plain arrays, which
/// compilers turn into vectors.
void place_faces(std::span<const Reference> references, const Grid& grid, int32_t* place) {
    for (const Reference& r : references) {
        float face[kFaces];
        std::memcpy(face, &r.lo, 4 * sizeof(float));
        std::memcpy(face + 4, &r.lo.z, 4 * sizeof(float));
        for (uint32_t k = 0; k < kFaces; ++k)
            place[k] = int32_t((face[k] - grid.base[k]) * grid.scale[k]) * int32_t(kFaces) + int32_t(k);
        place += kFaces;
    }
}

/// Two tables by turns: neighbours often fall into the same bin, and an increment waits for the one before.
void count_faces(std::span<const Reference> references, const Grid& grid, Counts& even, Counts& odd) {
    constexpr size_t kBlock = 32;
    int32_t place[kBlock * kFaces];
    for (size_t first = 0; first < references.size(); first += kBlock) {
        const size_t n = std::min(kBlock, references.size() - first);
        place_faces(references.subspan(first, n), grid, place);
        for (size_t i = 0; i < n; ++i)
            for (uint32_t k : {0, 1, 2, 5, 6, 7}) ++(i % 2 ? odd : even).count[size_t(place[kFaces * i + k])];
    }
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

}  // namespace

std::optional<Split> binned_split(std::span<const Reference> references, const Bounds& cell,
                                  const AccelOptions& options) {
    const int bins = std::min(options.bins, kMaxBins);
    const Grid grid(cell, bins);
    Counts counts;
    count_all(references, grid, bins, counts);
    std::optional<Split> best;
    for (uint32_t axis = 0; axis < 3; ++axis) {
        if (grid.scale[5 + axis] == 0) continue;
        const AxisCost cost(options, cell, axis);
        uint32_t left = 0, right = uint32_t(references.size());
        for (int k = 1; k < bins; ++k) {
            const uint32_t* bin = &counts.count[kFaces * size_t(k - 1)];
            left += bin[axis];
            right -= bin[5 + axis];
            keep_cheaper(best, cost, axis, grid.lo[int(axis)] + float(k) * grid.step[int(axis)], left, right);
        }
    }
    return best;
}

}  // namespace tress
