// SPDX-License-Identifier: MIT
#include "gather/photons/merge_photons.h"

#include <tbb/parallel_sort.h>

#include <array>

namespace tress {
namespace {

struct CellOfRow {
    glm::ivec3 cell, normal;
    uint32_t row;

    auto place() const { return std::array{cell.x, cell.y, cell.z, normal.x, normal.y, normal.z}; }
    bool operator<(const CellOfRow& other) const {
        const auto a = place(), b = other.place();
        return a != b ? a < b : row < other.row;
    }
};

float largest_coordinate(const PhotonList& list, std::span<const uint32_t> rows) {
    float largest = 0;
    for (const uint32_t row : rows) largest = glm::max(largest, max_component(abs(list.position(row))));
    return largest;
}

}  // namespace

PhotonList merge_photons(const PhotonList& list, std::span<const uint32_t> rows) {
    constexpr float kCells = 0x1p18f;  // from the middle to the farthest: 32 units in the last place of that each
    const float largest = largest_coordinate(list, rows), cells = largest > 0 ? kCells / largest : 0;
    std::vector<CellOfRow> sorted;
    sorted.reserve(rows.size());
    for (const uint32_t row : rows)
        sorted.push_back({glm::ivec3(round(cells * list.position(row))), glm::ivec3(round(list.normal[row])), row});
    tbb::parallel_sort(sorted.begin(), sorted.end());

    PhotonList merged;
    reserve(merged, sorted.size(), true);
    for (size_t i = 0; i < sorted.size(); ++i) {
        const uint32_t row = sorted[i].row;
        if (i > 0 && sorted[i].place() == sorted[i - 1].place()) {
            merged.power.back() += list.power[row];
        } else {
            add(merged, {list.position(row), list.direction[row], list.power[row], PathType(list.type[row])},
                list.normal[row]);
        }
    }
    return merged;
}

}  // namespace tress
