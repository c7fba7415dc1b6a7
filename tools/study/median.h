// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

namespace tress {

/// The mean of the middle two of an even number; 0 of none.
inline double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace tress
