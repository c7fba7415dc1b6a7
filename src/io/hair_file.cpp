// SPDX-License-Identifier: MIT
#include "io/hair_file.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

#include "core/error.h"
#include "core/shortest_text.h"
#include "io/whole_file.h"

namespace tress {
namespace {

// Flags of the arrays that a file has.
constexpr uint32_t kSegments = 1, kPoints = 2, kThickness = 4, kTransparency = 8, kColors = 16, kAllArrays = 31;

constexpr size_t kInfoBytes = 88;
constexpr uint32_t kMostSegments = std::numeric_limits<uint16_t>::max();

/// The header, field by field as it lies in the file.
struct Header {
    char magic[4] = {'H', 'A', 'I', 'R'};
    uint32_t strands = 0, points = 0, arrays = 0, segments = 0;
    float thickness = 0, transparency = 0, color[3] = {1, 1, 1};
    char info[kInfoBytes] = {};
};
static_assert(sizeof(Header) == 128);

bool is_magic(const char* m) { return std::memcmp(m, "HAIR", 4) == 0 || std::memcmp(m, "hair", 4) == 0; }

Header read_header(ByteReader& in) {
    Header h;
    in.need(1, sizeof(Header), "header");
    in.read(std::span(h.magic), "magic");
    if (!is_magic(h.magic)) throw InputError(in.path() + ": byte 0", "no .hair file, expected the letters HAIR");
    for (uint32_t* field : {&h.strands, &h.points, &h.arrays, &h.segments}) *field = in.read<uint32_t>("header");
    for (float* field : {&h.thickness, &h.transparency}) *field = in.read<float>("header");
    in.read(std::span(h.color), "header");
    in.read(std::span(h.info), "header");
    return h;
}

uint64_t bytes_of_arrays(const Header& h) {
    const uint64_t floats_a_point =
        3 + ((h.arrays & kThickness) ? 1 : 0) + ((h.arrays & kTransparency) ? 1 : 0) + ((h.arrays & kColors) ? 3 : 0);
    return ((h.arrays & kSegments) ? uint64_t(h.strands) * sizeof(uint16_t) : 0) +
           uint64_t(h.points) * floats_a_point * sizeof(float);
}

void check_header(const ByteReader& in, const Header& h) {
    const std::string& path = in.path();
    if (h.strands == 0) throw InputError(path + ": byte 4", "no strands");
    if (h.arrays & ~kAllArrays)
        throw InputError(path + ": byte 12",
                         "unknown arrays (flags " + std::to_string(h.arrays) + "), expected 1 to 31");
    if (!(h.arrays & kPoints)) throw InputError(path + ": byte 12", "no array of points, expected one");
    if (!(h.arrays & kThickness) && h.thickness < 0)
        throw InputError(path + ": byte " + std::to_string(offsetof(Header, thickness)),
                         shortest_text(h.thickness) + " as the thickness of all hair, expected none below 0");
    const uint64_t expected = sizeof(Header) + bytes_of_arrays(h);
    if (in.size() != expected)
        throw InputError(path + ": byte " + std::to_string(std::min(in.size(), expected)),
                         std::to_string(in.size()) + " bytes in all, expected " + std::to_string(expected) + " for " +
                             std::to_string(h.strands) + " strands and " + std::to_string(h.points) + " points");
}

/// first[] of all strands; the points they say they have must be those of the header.
std::vector<uint32_t> read_first(ByteReader& in, const Header& h) {
    const bool all_alike = !(h.arrays & kSegments);
    std::vector<uint16_t> segments;
    if (!all_alike) segments = in.read_vector<uint16_t>(h.strands, "segments");
    uint64_t points = uint64_t(h.strands) * (uint64_t(h.segments) + 1);
    if (!all_alike) {
        points = h.strands;
        for (const uint16_t n : segments) points += n;
    }
    if (points != h.points)
        throw InputError(in.path() + ": byte 8", std::to_string(h.points) + " points, expected " +
                                                     std::to_string(points) + ", the sum over all strands");
    std::vector<uint32_t> first(size_t(h.strands) + 1);
    for (size_t s = 0; s < h.strands; ++s) first[s + 1] = first[s] + (all_alike ? h.segments : segments[s]) + 1;
    return first;
}

template <class T>
void write_array(WholeFile& out, const std::vector<T>& array) {
    out.write(array.data(), array.size() * sizeof(T));
}

/// Segments of each strand; empty where all have as many, which `alike` then says.
std::vector<uint16_t> segments_of(const std::string& path, const StrandSet& strands, uint32_t& alike) {
    std::vector<uint16_t> segments(strands.strands());
    bool are_alike = true;
    for (size_t s = 0; s < segments.size(); ++s) {
        const uint32_t n = strands.first[s + 1] - strands.first[s] - 1;
        if (n > kMostSegments)
            throw InputError(path, "strand " + std::to_string(s) + " has " + std::to_string(n) +
                                       " segments, expected at most " + std::to_string(kMostSegments));
        segments[s] = uint16_t(n);
        are_alike &= segments[s] == segments[0];
    }
    alike = segments.empty() ? 0 : segments[0];
    if (are_alike) segments.clear();
    return segments;
}

}  // namespace

bool has_hair_magic(const std::string& path) {
    ByteReader in(path);
    char magic[4] = {};
    if (in.size() < sizeof magic) return false;
    in.read(std::span(magic), "magic");
    return is_magic(magic);
}

HairFile read_hair_file(const std::string& path) {
    ByteReader in(path);
    const Header h = read_header(in);
    check_header(in, h);
    HairFile hair;
    StrandSet& strands = hair.strands;
    strands.first = read_first(in, h);
    for (std::vector<float>* axis : {&strands.x, &strands.y, &strands.z}) axis->reserve(h.points);
    append_points(in, h.points, 3, strands);
    if (h.arrays & kThickness) strands.radius = in.read_vector<float>(h.points, "thickness");
    for (float& radius : strands.radius) radius *= 0.5f;
    if (h.arrays & kTransparency) hair.transparency = in.read_vector<float>(h.points, "transparency");
    if (h.arrays & kColors) append_colors(in, h.points, 3, strands.color);
    if (std::isfinite(h.thickness) && h.thickness > 0) strands.constant_radius = 0.5f * h.thickness;
    hair.default_transparency = h.transparency;
    hair.default_color = {h.color[0], h.color[1], h.color[2]};
    hair.info.assign(h.info, strnlen(h.info, kInfoBytes));
    const uint64_t counts_at = (h.arrays & kSegments) ? sizeof(Header) : offsetof(Header, segments);
    hair.dropped_strands = drop_short_strands(path, counts_at, strands, hair.transparency);
    return hair;
}

void write_hair_file(const std::string& path, const HairFile& hair) {
    static_assert(std::endian::native == std::endian::little, "arrays are written as they lie in memory");
    const StrandSet& strands = hair.strands;
    if (strands.strands() == 0) throw InputError(path, "no strands to write");
    check_point_count(path, strands.points());
    Header h;
    const std::vector<uint16_t> segments = segments_of(path, strands, h.segments);
    h.strands = uint32_t(strands.strands());
    h.points = uint32_t(strands.points());
    h.arrays = kPoints | (segments.empty() ? 0 : kSegments) | (strands.radius.empty() ? 0 : kThickness) |
               (hair.transparency.empty() ? 0 : kTransparency) | (strands.color.empty() ? 0 : kColors);
    h.thickness = 2 * strands.constant_radius;
    h.transparency = hair.default_transparency;
    for (int c = 0; c < 3; ++c) h.color[c] = hair.default_color[c];
    std::memcpy(h.info, hair.info.data(), std::min(hair.info.size(), kInfoBytes));

    WholeFile out(path);
    out.write(&h, sizeof h);
    write_array(out, segments);
    std::vector<Vec3> points(strands.points());
    for (size_t p = 0; p < points.size(); ++p) points[p] = strands.point(p);
    write_array(out, points);
    std::vector<float> thickness = strands.radius;
    for (float& width : thickness) width *= 2;
    write_array(out, thickness);
    write_array(out, hair.transparency);
    write_array(out, strands.color);
    out.commit();
}

}  // namespace tress
