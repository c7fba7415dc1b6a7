// SPDX-License-Identifier: MIT
// One-dimensional filters on planes of floats. Outside a plane lies the nearest value of its edge.
#pragma once

#include <span>
#include <vector>

namespace tress {

/// Odd number of weights; the middle one is for the pixel itself. Output(x) = sum of weight[radius + j] input(x + j).
struct Kernel {
    std::vector<float> weight;

    int radius() const { return int(weight.size() / 2); }
};

struct Plane {
    int width = 0, height = 0;
    std::vector<float> value;  // row by row

    std::span<float> row(int y) { return {value.data() + size_t(y) * size_t(width), size_t(width)}; }
    std::span<const float> row(int y) const { return {value.data() + size_t(y) * size_t(width), size_t(width)}; }
};
Plane make_plane(int width, int height);

/// Filters one row along itself. `padded` is scratch space.
void filter_along_row(std::span<const float> row, const Kernel& kernel, std::vector<float>& padded,
                      std::span<float> out);

/// Row y of the plane filtered down its columns: added to `out`.
void add_filtered_column(const Plane& plane, const Kernel& kernel, int y, std::span<float> out);

}  // namespace tress
