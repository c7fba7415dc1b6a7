// SPDX-License-Identifier: MIT
// Where an axis has its ticks, and what stands at them.
#pragma once

#include <string>
#include <vector>

#include "io/plot/plot_axis.h"

namespace tress::svg {

struct Tick {
    double at;  // in units
    std::string label;
    double width;  // of the label; 0: a minor tick

    bool major() const { return width > 0; }
};

/// At most `most` labels, about.
std::vector<Tick> ticks_of(const Axis& axis, int most);
/// As many as keep clear of each other side by side.
std::vector<Tick> ticks_across(const Axis& axis);

}  // namespace tress::svg
