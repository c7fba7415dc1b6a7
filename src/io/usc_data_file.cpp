// SPDX-License-Identifier: MIT
#include "io/usc_data_file.h"

namespace tress {
namespace {

constexpr uint64_t kPointBytes = 3 * sizeof(float), kCountBytes = sizeof(int32_t);

uint64_t read_count(ByteReader& in, const char* what) {
    const int32_t count = in.read<int32_t>(what);
    if (count < 0) in.fail(std::to_string(count) + " as the " + what + ", expected none below 0");
    return uint64_t(count);
}

}  // namespace

StrandData read_usc_data_file(const std::string& path) {
    ByteReader in(path);
    StrandData data;
    StrandSet& strands = data.strands;
    const uint64_t count = read_count(in, "number of strands");
    if (count == 0) in.fail("no strands");
    in.need(count, kCountBytes, "strands");
    const uint64_t points = (in.remaining() - count * kCountBytes) / kPointBytes;
    check_point_count(path, points);
    for (std::vector<float>* axis : {&strands.x, &strands.y, &strands.z}) axis->reserve(points);
    strands.first.reserve(count + 1);
    strands.first.push_back(0);
    for (uint64_t s = 0; s < count; ++s) {
        append_points(in, read_count(in, "number of points"), 3, strands);
        strands.first.push_back(uint32_t(strands.points()));
    }
    if (in.remaining() > 0) in.fail(std::to_string(in.remaining()) + " bytes after the last strand, expected none");
    std::vector<float> no_extra;
    data.dropped_strands = drop_short_strands(path, kCountBytes, strands, no_extra);
    return data;
}

}  // namespace tress
