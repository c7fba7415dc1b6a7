// SPDX-License-Identifier: MIT
#include "core/nearest_name.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace tress {
namespace {

/// Levenshtein distance.
size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), size_t(0));
    for (size_t i = 1; i <= a.size(); ++i) {
        size_t diagonal = row[0];
        row[0] = i;
        for (size_t j = 1; j <= b.size(); ++j) {
            const size_t substituted = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
        }
    }
    return row[b.size()];
}

constexpr size_t kLongestName = 200;  // longer input is cut: messages need no more, and the cost is quadratic

}  // namespace

std::string nearest_name(std::string_view name, std::span<const std::string> known) {
    const std::string_view cut = name.substr(0, kLongestName);
    return *std::min_element(known.begin(), known.end(), [&](const std::string& a, const std::string& b) {
        return edit_distance(cut, a) < edit_distance(cut, b);
    });
}

std::string did_you_mean(std::string_view name, std::span<const std::string> known) {
    return "nearest known: '" + nearest_name(name, known) + "'";
}

}  // namespace tress
