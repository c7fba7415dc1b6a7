// SPDX-License-Identifier: MIT
#include "io/tfx_file.h"

#include "core/error.h"

namespace tress {
namespace {

constexpr uint64_t kHeaderBytes3 = 296, kHeaderBytes4 = 160;

/// Where the arrays are, in bytes from the start of the file; 0: absent.
struct Layout {
    uint64_t positions = 0, thickness = 0, colors = 0;
    int floats_a_point = 3;
};

Layout read_layout(ByteReader& in, float version) {
    if (version < 4) return {kHeaderBytes3, 0, 0, 3};
    uint32_t offset[5];  // positions, strand uv, vertex uv, strand thickness, vertex colour
    in.read(std::span(offset), "offsets");
    for (const uint32_t o : {offset[0], offset[3], offset[4]})
        if (o != 0 && o < kHeaderBytes4)
            in.fail("an array at byte " + std::to_string(o) + ", expected none before byte " +
                    std::to_string(kHeaderBytes4));
    if (offset[0] == 0) in.fail("no positions, expected some");
    return {offset[0], offset[3], offset[4], 4};
}

void read_radii(ByteReader& in, uint64_t offset, uint32_t points_a_strand, StrandSet& strands) {
    in.seek(offset, "thickness");
    const std::vector<float> thickness = in.read_vector<float>(strands.strands(), "thickness");
    strands.radius.reserve(strands.points());
    for (const float width : thickness) strands.radius.insert(strands.radius.end(), points_a_strand, 0.5f * width);
}

}  // namespace

StrandData read_tfx_file(const std::string& path) {
    ByteReader in(path);
    const float version = in.read<float>("version");
    if (!(version >= 3 && version < 5))
        throw InputError(path + ": byte 0", "no .tfx file of version 3 or 4, expected 3.0 or 4.0 in 4 bytes");
    const uint32_t count = in.read<uint32_t>("number of strands");
    const uint32_t points_a_strand = in.read<uint32_t>("points a strand");
    if (count == 0) throw InputError(path + ": byte 4", "no strands");
    if (points_a_strand < 2)
        throw InputError(path + ": byte 8", std::to_string(points_a_strand) + " points a strand, expected 2 or more");
    const Layout layout = read_layout(in, version);
    const uint64_t points = uint64_t(count) * points_a_strand;
    in.seek(layout.positions, "positions");
    in.need(points, size_t(layout.floats_a_point) * sizeof(float), "points");
    check_point_count(path, points);

    StrandData data;
    StrandSet& strands = data.strands;
    for (std::vector<float>* axis : {&strands.x, &strands.y, &strands.z}) axis->reserve(points);
    append_points(in, points, layout.floats_a_point, strands);
    strands.first.resize(size_t(count) + 1);
    for (size_t s = 0; s <= count; ++s) strands.first[s] = uint32_t(s * points_a_strand);
    if (layout.thickness != 0) read_radii(in, layout.thickness, points_a_strand, strands);
    if (layout.colors != 0) {
        in.seek(layout.colors, "colours");
        append_colors(in, points, 4, strands.color);
    }
    return data;
}

}  // namespace tress
