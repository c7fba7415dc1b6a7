// SPDX-License-Identifier: MIT
#include "core/separable_filter.h"

#include <algorithm>

namespace tress {
namespace {

/// out += weight * in, without overlap: the loop that the compiler turns into vectors.
void add_scaled(const float* in, float weight, std::span<float> out) {
    float* __restrict sum = out.data();
    const float* __restrict source = in;
    for (size_t x = 0; x < out.size(); ++x) sum[x] += weight * source[x];
}

}  // namespace

Plane make_plane(int width, int height) {
    return {width, height, std::vector<float>(size_t(width) * size_t(height), 0.0f)};
}

void filter_along_row(std::span<const float> row, const Kernel& kernel, std::vector<float>& padded,
                      std::span<float> out) {
    const size_t radius = size_t(kernel.radius());
    padded.resize(row.size() + 2 * radius);
    std::fill_n(padded.begin(), radius, row.front());
    std::copy(row.begin(), row.end(), padded.begin() + std::ptrdiff_t(radius));
    std::fill(padded.end() - std::ptrdiff_t(radius), padded.end(), row.back());
    std::fill(out.begin(), out.end(), 0.0f);
    for (size_t j = 0; j < kernel.weight.size(); ++j) add_scaled(padded.data() + j, kernel.weight[j], out);
}

void add_filtered_column(const Plane& plane, const Kernel& kernel, int y, std::span<float> out) {
    const int radius = kernel.radius();
    for (int j = -radius; j <= radius; ++j) {
        const int from = std::clamp(y + j, 0, plane.height - 1);
        add_scaled(plane.row(from).data(), kernel.weight[size_t(j + radius)], out);
    }
}

}  // namespace tress
