// SPDX-License-Identifier: MIT
// Colours, marks and style rules of plots, on light and dark ground and on paper.
#pragma once

#include <array>
#include <cstddef>
#include <string>

namespace tress::svg {

inline constexpr size_t kColors = 8;

// Circle, square, triangle, diamond, triangle on its tip, plus, cross, star; all about their origin.
inline constexpr std::array<const char*, kColors> kMarks = {
    "M-3.8 0a3.8 3.8 0 1 0 7.6 0a3.8 3.8 0 1 0-7.6 0z",
    "M-3.4-3.4h6.8v6.8h-6.8z",
    "M0-4.6L4.4 3.2H-4.4z",
    "M0-5L5 0L0 5L-5 0z",
    "M0 4.6L4.4-3.2H-4.4z",
    "M-1.5-4.6h3v3.1h3.1v3h-3.1v3.1h-3v-3.1h-3.1v-3h3.1z",
    "M-4.3-2.2L-2.2-4.3L0-2.1L2.2-4.3L4.3-2.2L2.1 0L4.3 2.2L2.2 4.3L0 2.1L-2.2 4.3L-4.3 2.2L-2.1 0z",
    "M0-5.4L1.4-1.9L5.1-1.7L2.3 .8L3.2 4.4L0 2.4L-3.2 4.4L-2.3 .8L-5.1-1.7L-1.4-1.9z"};

/// A <style> whose rules reach elements of class "plot" alone.
std::string style();

}  // namespace tress::svg
