// SPDX-License-Identifier: MIT
#include "io/hair_file.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "core/bounds.h"
#include "core/segments.h"
#include "io/strand_file.h"
#include "tests/io_support.h"
#include "tools/check/support/raw_hair.h"

using namespace tress;
using namespace tress::test;

namespace {

/// Bits of the arrays in the format, in the order they lie in a file.
constexpr uint32_t kSegments = 1, kThickness = 4, kTransparency = 8, kColors = 16;

HairFile sample_hair(uint32_t arrays) {
    HairFile hair;
    StrandSet& s = hair.strands;
    const std::vector<uint32_t> points =
        (arrays & kSegments) ? std::vector<uint32_t>{2, 5, 3} : std::vector<uint32_t>{4, 4};
    s.first = {0};
    for (const uint32_t n : points) s.first.push_back(s.first.back() + n);
    for (uint32_t p = 0; p < s.first.back(); ++p) {
        const float v = float(p);
        s.add_point({v, 0.1f * v, -v});
        if (arrays & kThickness) s.radius.push_back(0.01f + 0.001f * v);
        if (arrays & kTransparency) hair.transparency.push_back(0.05f * v);
        if (arrays & kColors) s.color.emplace_back(0.1f * v, 0.5f, 1 - 0.1f * v);
    }
    s.constant_radius = 0.05f;
    hair.default_transparency = 0.25f;
    hair.default_color = {0.75f, 0.5f, 0.25f};
    hair.info = "made for a test";
    return hair;
}

void check_equal(const HairFile& a, const HairFile& b) {
    CHECK(a.strands.first == b.strands.first);
    CHECK(a.strands.x == b.strands.x);
    CHECK(a.strands.y == b.strands.y);
    CHECK(a.strands.z == b.strands.z);
    CHECK(a.strands.radius == b.strands.radius);
    CHECK(a.strands.color == b.strands.color);
    CHECK(a.strands.constant_radius == b.strands.constant_radius);
    CHECK(a.transparency == b.transparency);
    CHECK(a.default_transparency == b.default_transparency);
    CHECK(a.default_color == b.default_color);
    CHECK(a.info == b.info);
}

}  // namespace

TEST_CASE("hair with each combination of arrays is read as it was written, byte for byte") {
    const Folder folder;
    const std::string path = folder.file("a.hair"), again = folder.file("b.hair");
    for (uint32_t arrays = 0; arrays < 32; ++arrays) {
        if (arrays & 2) continue;  // points are always there
        CAPTURE(arrays);
        const HairFile hair = sample_hair(arrays);
        write_hair_file(path, hair);
        const HairFile read = read_hair_file(path);
        check_equal(read, hair);
        CHECK(read.dropped_strands == 0);
        write_hair_file(again, read);
        CHECK(read_bytes(path) == read_bytes(again));
    }
}

TEST_CASE("thickness is a width: the radius is half of it") {
    const Folder folder;
    std::string arrays = point_bytes(2);
    for (const float width : {0.5f, 0.25f}) append(arrays, width);
    const HairFile hair = read_hair_file(write_bytes(folder.file("a.hair"), raw_hair(1, 2, 2 | kThickness, 1, arrays)));
    CHECK(hair.strands.radius == std::vector<float>{0.25f, 0.125f});
    CHECK(hair.strands.constant_radius == 0.05f);
}

TEST_CASE("the first four letters may be small") {
    const Folder folder;
    std::string bytes = raw_hair(1, 2, 2, 1, point_bytes(2));
    bytes.replace(0, 4, "hair");
    CHECK(read_strand_file(write_bytes(folder.file("a.hair"), bytes)).strands.points() == 2);
    CHECK(read_strand_file(write_bytes(folder.file("no-ending"), bytes)).strands.points() == 2);
}

TEST_CASE("strands of one point are dropped and counted, with what belongs to them") {
    const Folder folder;
    std::string arrays;
    for (const uint16_t segments : {0, 1, 0}) append(arrays, segments);
    arrays += point_bytes(4);
    for (int p = 0; p < 4; ++p) append(arrays, float(p));  // thickness
    const HairFile hair =
        read_hair_file(write_bytes(folder.file("a.hair"), raw_hair(3, 4, 2 | kSegments | kThickness, 0, arrays)));
    CHECK(hair.dropped_strands == 2);
    CHECK(hair.strands.first == std::vector<uint32_t>{0, 2});
    CHECK(hair.strands.x == std::vector<float>{4, 7});
    CHECK(hair.strands.radius == std::vector<float>{0.5f, 1});
}

TEST_CASE("points that are not finite pass through") {
    const Folder folder;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const HairFile hair = read_hair_file(write_bytes(folder.file("a.hair"), raw_hair(1, 2, 2, 1, point_bytes(2, nan))));
    CHECK(std::isnan(hair.strands.x[0]));
    CHECK(list_segments(hair.strands).dropped == 1);
}

TEST_CASE("a strand may have 65,535 segments and no more") {
    const Folder folder;
    HairFile hair;
    for (uint32_t p = 0; p <= 65535; ++p) hair.strands.add_point({float(p), 0, 0});
    hair.strands.first = {0, 65536};
    write_hair_file(folder.file("a.hair"), hair);
    check_equal(read_hair_file(folder.file("a.hair")), hair);
    hair.strands.add_point({0, 0, 0});
    hair.strands.first = {0, 65537};
    CHECK(contains(message_of([&] { write_hair_file(folder.file("b.hair"), hair); }), "65536 segments"));
    CHECK(folder.entries() == 1);
}

TEST_CASE("headers that lie are refused in one line, whatever they claim") {
    const Folder folder;
    const uint32_t most = 0xffffffff;
    const std::string points = point_bytes(2);
    const std::pair<std::string, std::string> bad[] = {
        {raw_hair(0, 0, 2, 1, ""), "no strands"},
        {raw_hair(0, 2, 2, 1, points), "no strands"},
        {raw_hair(1, 2, 1, 1, points), "no array of points"},
        {raw_hair(1, 2, 2 | 32, 1, points), "unknown arrays"},
        {raw_hair(most, most, 31, most, points), "expected"},
        {raw_hair(most, 2, 2, most, points), "expected"},
        {raw_hair(1, most, 2, 1, points), "expected"},
        {raw_hair(2, 2, 2, 0, points), "no strands of two points"},
        {raw_hair(1, 2, 2, 2, points), "2 points, expected 3"},
        {raw_hair(1, 2, 2, 1, points + "x"), "byte 152: 153 bytes in all, expected 152"},
        {"HAIR", "byte 0"},
        {"", "byte 0"},
        {std::string(200, 'x'), "expected the letters HAIR"},
    };
    for (const auto& [bytes, part] : bad) {
        const std::string path = write_bytes(folder.file("a.hair"), bytes);
        const std::string message = message_of([&] { read_hair_file(path); });
        CAPTURE(message);
        CAPTURE(part);
        CHECK(is_one_line(message));
        CHECK(contains(message, path));
        CHECK(contains(message, part));
    }
}

TEST_CASE("a .hair file cut at any byte is refused") {
    const Folder folder;
    write_hair_file(folder.file("a.hair"), sample_hair(kSegments | kThickness | kTransparency | kColors));
    const std::string bytes = read_bytes(folder.file("a.hair"));
    for (size_t length = 0; length < bytes.size(); ++length) {
        CAPTURE(length);
        const std::string path = write_bytes(folder.file("cut.hair"), bytes.substr(0, length));
        CHECK(is_one_line(message_of([&] { read_strand_file(path); })));
    }
}

TEST_CASE("a .data file holds strands of any number of points") {
    const Folder folder;
    std::string bytes;
    append(bytes, int32_t(3));
    for (const int32_t points : {2, 1, 3}) {
        append(bytes, points);
        bytes += point_bytes(size_t(points), float(points));
    }
    const StrandData data = read_strand_file(write_bytes(folder.file("a.data"), bytes));
    CHECK(data.dropped_strands == 1);
    CHECK(data.strands.first == std::vector<uint32_t>{0, 2, 5});
    CHECK(data.strands.point(2) == Vec3(3, 4, 5));
    for (size_t length = 0; length < bytes.size(); ++length) {
        CAPTURE(length);
        const std::string path = write_bytes(folder.file("cut.data"), bytes.substr(0, length));
        CHECK(is_one_line(message_of([&] { read_strand_file(path); })));
    }
    for (const int32_t count : {0, -1, 4, 0x7fffffff}) {
        CAPTURE(count);
        std::memcpy(bytes.data(), &count, sizeof count);
        write_bytes(folder.file("a.data"), bytes);
        CHECK(is_one_line(message_of([&] { read_strand_file(folder.file("a.data")); })));
    }
}

TEST_CASE("a .tfx file of version 4 holds thickness and colours where it says so") {
    const Folder folder;
    const uint32_t strands = 2, points = 3, header = 160;
    const uint32_t position_bytes = strands * points * 16, thickness = header + position_bytes;
    std::string bytes;
    append(bytes, 4.0f);
    for (const uint32_t field : {strands, points, header, 0u, 0u, thickness, thickness + 8}) append(bytes, field);
    bytes.resize(header);
    for (uint32_t p = 0; p < strands * points; ++p)
        for (const float v : {float(p), 2.0f, 3.0f, 1.0f}) append(bytes, v);
    for (const float width : {0.5f, 1.0f}) append(bytes, width);
    for (uint32_t p = 0; p < strands * points; ++p)
        for (const float v : {0.1f * float(p), 0.2f, 0.3f, 1.0f}) append(bytes, v);

    const StrandSet s = read_strand_file(write_bytes(folder.file("a.tfx"), bytes)).strands;
    CHECK(s.first == std::vector<uint32_t>{0, 3, 6});
    CHECK(s.point(5) == Vec3(5, 2, 3));
    CHECK(s.radius == std::vector<float>{0.25f, 0.25f, 0.25f, 0.5f, 0.5f, 0.5f});
    CHECK(s.color[2] == Rgb(0.2f, 0.2f, 0.3f));
    for (size_t length = 0; length < bytes.size(); ++length) {
        CAPTURE(length);
        const std::string path = write_bytes(folder.file("cut.tfx"), bytes.substr(0, length));
        CHECK(is_one_line(message_of([&] { read_strand_file(path); })));
    }
}

TEST_CASE("real hair has the counts and bounds that are known of it") {
    struct Known {
        const char* name;
        size_t strands, points, segments;
        DVec3 lo, hi;
    };
    const Known files[] = {
        {"hair/yuksel/straight.hair", 10000, 160000, 150000, {-32.50, -33.90, -22.71}, {30.90, 24.07, 63.68}},
        {"hair/tressfx-ponytail/side.tfx", 3066, 49056, 45990, {-32.43, 16.88, -36.28}, {32.94, 123.71, 46.61}},
        {"hair/tressfx-ponytail/front_top.tfx", 969, 15504, 14535, {-25.43, 50.67, -35.81}, {29.34, 123.63, 44.66}},
        {"hair/tressfx-ponytail/back.tfx", 517, 8272, 7755, {-22.59, 62.43, 17.48}, {20.69, 103.92, 44.55}},
        {"hair/tressfx-ponytail/tail.tfx", 255, 4080, 3825, {-4.49, -3.12, 45.24}, {12.32, 83.02, 77.99}},
        {"hair/tressfx-bear/bear.tfx", 48113, 192452, 144339, {-42.20, -0.79, -159.25}, {42.38, 114.11, 40.12}},
        {"hair/tressfx-ratboy/Ratboy_mohawk.tfx",
         2228,
         71296,
         69068,
         {-0.0951, 0.2143, -0.3358},
         {0.1173, 1.1099, 0.2709}},
        {"hair/sintel/sintel_hair.tfx", 228, 7296, 7068, {-11.61, 18.81, -13.04}, {10.00, 47.85, 11.90}},
        {"hair/digital-salon/harolongo.data", 7905, 166005, 158100, {-11.83, -14.26, -18.62}, {10.50, 14.20, 4.59}},
    };
    for (const Known& known : files) {
        const std::string name = known.name;
        CAPTURE(name);
        const auto path = real_file(known.name);
        if (!path) continue;
        const StrandData data = read_strand_file(*path);
        const StrandSet& s = data.strands;
        CHECK(s.strands() == known.strands);
        CHECK(s.points() == known.points);
        CHECK(s.points() - s.strands() == known.segments);
        CHECK(data.dropped_strands == 0);
        DBounds box;
        for (size_t p = 0; p < s.points(); ++p) box.add(DVec3(s.point(p)));
        const double digit = known.hi.y < 2 ? 1e-4 : 1e-2;  // the last one known, rounded or cut
        for (int axis = 0; axis < 3; ++axis) {
            CHECK(std::abs(box.lo[axis] - known.lo[axis]) <= digit);
            CHECK(std::abs(box.hi[axis] - known.hi[axis]) <= digit);
        }
    }
}

TEST_CASE("a real .hair file is written again byte for byte") {
    const auto path = real_file("hair/yuksel/straight.hair");
    if (!path) return;
    const Folder folder;
    const HairFile hair = read_hair_file(*path);
    CHECK(hair.strands.constant_radius == 0.05f);
    CHECK(hair.strands.color.size() == 160000);
    write_hair_file(folder.file("a.hair"), hair);
    CHECK(read_bytes(folder.file("a.hair")) == read_bytes(*path));
}
