// SPDX-License-Identifier: MIT
#include "io/strand_data.h"

#include <limits>

#include "core/error.h"

namespace tress {
namespace {

constexpr uint64_t kRowsAtOnce = 4096;  // 64 kB of points: no second copy of the file is held

/// Calls use(row) for each of `count` rows of `floats_each` numbers.
template <class Use>
void for_each_row(ByteReader& in, uint64_t count, int floats_each, const char* what, Use&& use) {
    in.need(count, size_t(floats_each) * sizeof(float), what);
    std::vector<float> rows(std::min(count, kRowsAtOnce) * size_t(floats_each));
    for (uint64_t done = 0; done < count;) {
        const uint64_t n = std::min(count - done, kRowsAtOnce);
        in.read(std::span(rows).first(n * size_t(floats_each)), what);
        for (uint64_t i = 0; i < n; ++i) use(&rows[i * size_t(floats_each)]);
        done += n;
    }
}

/// Keeps only the rows of `array` listed in `kept`, which ascends.
template <class T>
void keep_rows(std::vector<T>& array, const std::vector<uint32_t>& kept) {
    if (array.empty()) return;
    for (size_t i = 0; i < kept.size(); ++i) array[i] = array[kept[i]];
    array.resize(kept.size());
}

}  // namespace

void append_points(ByteReader& in, uint64_t count, int floats_each, StrandSet& strands) {
    for_each_row(in, count, floats_each, "points", [&](const float* row) {
        strands.add_point({row[0], row[1], row[2]});
    });
}

void append_colors(ByteReader& in, uint64_t count, int floats_each, std::vector<Rgb>& colors) {
    in.need(count, size_t(floats_each) * sizeof(float), "colours");
    colors.reserve(colors.size() + count);
    for_each_row(in, count, floats_each, "colours",
                 [&](const float* row) { colors.emplace_back(row[0], row[1], row[2]); });
}

uint64_t drop_short_strands(const std::string& path, uint64_t counts_at, StrandSet& strands,
                            std::vector<float>& extra) {
    std::vector<uint32_t> kept, first{0};
    const auto is_short = [&](size_t s) { return strands.first[s + 1] - strands.first[s] < 2; };
    uint64_t dropped = 0;
    for (size_t s = 0; s < strands.strands(); ++s) dropped += is_short(s);
    if (dropped == strands.strands())
        throw InputError(path + ": byte " + std::to_string(counts_at), "no strands of two points or more");
    if (dropped == 0) return 0;
    for (size_t s = 0; s < strands.strands(); ++s) {
        if (is_short(s)) continue;
        for (uint32_t p = strands.first[s]; p < strands.first[s + 1]; ++p) kept.push_back(p);
        first.push_back(uint32_t(kept.size()));
    }
    strands.first = std::move(first);
    for (std::vector<float>* array : {&strands.x, &strands.y, &strands.z, &strands.radius, &extra})
        keep_rows(*array, kept);
    keep_rows(strands.color, kept);
    return dropped;
}

void check_point_count(const std::string& path, uint64_t points) {
    constexpr uint64_t kMost = std::numeric_limits<uint32_t>::max();
    if (points > kMost)
        throw InputError(path, std::to_string(points) + " points, expected at most " + std::to_string(kMost));
}

}  // namespace tress
