// SPDX-License-Identifier: MIT
#include "core/sampling.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace tress {
namespace {

constexpr double kWindow[4] = {0.35875, 0.48829, 0.14128, 0.01168};  // Harris 1978, 4-term, -92 dB
constexpr int kIntervals = 1024;

/// Share of the window over [-1, 1] that lies below x.
double cumulative(double x) {
    double sum = kWindow[0] * (x + 1);
    for (int k = 1; k < 4; ++k) sum += kWindow[k] * std::sin(k * std::numbers::pi * x) / (k * std::numbers::pi);
    return sum / (2 * kWindow[0]);
}

/// `cumulative` at even steps over the lower half, [-1, 0]; the window is symmetric, and near 0 floats are fine.
using Table = std::array<float, kIntervals + 1>;
Table make_table() {
    Table table;
    for (int i = 0; i <= kIntervals; ++i) table[size_t(i)] = float(cumulative(double(i) / kIntervals - 1));
    table.front() = 0;
    table.back() = 0.5f;
    return table;
}

}  // namespace

float sample_blackman_harris(float u, float radius) {
    static const Table table = make_table();
    const float tail = std::min(u, 1 - u);
    const auto above = std::upper_bound(table.begin() + 1, table.end() - 1, tail);
    const float lower = *(above - 1), step = *above - lower;
    const float part = step > 0 ? std::min((tail - lower) / step, 1.0f) : 0.0f;
    const float x = (float(above - 1 - table.begin()) + part) / kIntervals - 1;
    return u < 0.5f ? radius * x : -radius * x;
}

float pdf_blackman_harris(float offset, float radius) {
    const double x = double(offset) / double(radius);
    if (!(std::abs(x) <= 1)) return 0;
    double window = kWindow[0];
    for (int k = 1; k < 4; ++k) window += kWindow[k] * std::cos(k * std::numbers::pi * x);
    return float(window / (2 * kWindow[0] * double(radius)));
}

}  // namespace tress
