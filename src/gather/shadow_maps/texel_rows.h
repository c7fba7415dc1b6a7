// SPDX-License-Identifier: MIT
// Tables with a row for every texel that has hair; the others cost an index and nothing else.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace tress {

struct TexelRows {
    static constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();
    std::vector<uint32_t> row;  // one a texel (texel_index); kNone: no hair stops light there
    uint32_t count = 0;         // of rows, in the order of texels
};

inline void add_texel(TexelRows& rows, bool has_hair) { rows.row.push_back(has_hair ? rows.count++ : rows.kNone); }

/// Rows of `tile` come after those of `to`.
inline void append(TexelRows& to, const TexelRows& tile) {
    for (const uint32_t row : tile.row) to.row.push_back(row == TexelRows::kNone ? row : to.count + row);
    to.count += tile.count;
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& tile) {
    to.insert(to.end(), tile.begin(), tile.end());
}

template <class T>
size_t bytes(const std::vector<T>& values) {
    return values.size() * sizeof(T);
}

}  // namespace tress
