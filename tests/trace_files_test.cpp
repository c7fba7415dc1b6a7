// SPDX-License-Identifier: MIT
// Files of segments, rays and hits.
#include "io/trace_files.h"

#include <doctest/doctest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "core/error.h"

using namespace tress;

namespace {

/// A file of this test's own, gone at its end.
struct Scratch {
    std::string path;

    explicit Scratch(const std::string& name)
        : path((std::filesystem::temp_directory_path() / ("tress_trace_files_" + name)).string()) {}
    ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
    }
    void write(const std::string& bytes) const { std::ofstream(path, std::ios::binary) << bytes; }
};

std::string header(const char* magic, uint64_t count) {
    std::string bytes(magic, 8);
    bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
    return bytes;
}
std::string floats(const std::vector<float>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}
std::string refusal(const Scratch& file) {
    try {
        read_trace_segments(file.path);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("segments, rays and hits read back as they were written") {
    TraceSegments s;
    TraceRays r;
    TraceHits h;
    for (uint32_t i = 0; i < 5000; ++i) {  // more than one batch of the reader
        const float f = float(i);
        s.point.push_back(2 * i);
        for (const float end : {0.25f, 0.75f}) {
            s.x.push_back(f + end), s.y.push_back(-f), s.z.push_back(end * f), s.radius.push_back(0.5f);
        }
        r.ox.push_back(f), r.oy.push_back(1), r.oz.push_back(2), r.t_near.push_back(3);
        r.dx.push_back(-f), r.dy.push_back(5), r.dz.push_back(6), r.t_far.push_back(1e30f);
        h.t.push_back(f), h.segment.push_back(0xffffffffu - i), h.transmittance.push_back(0.5f),
            h.crossings.push_back(i);
    }
    const Scratch file("round_trip");
    write_trace_segments(file.path, s);
    const TraceSegments s2 = read_trace_segments(file.path);
    CHECK((s2.x == s.x && s2.y == s.y && s2.z == s.z && s2.radius == s.radius && s2.point == s.point));
    write_trace_rays(file.path, r);
    const TraceRays r2 = read_trace_rays(file.path);
    CHECK((r2.ox == r.ox && r2.oy == r.oy && r2.oz == r.oz && r2.t_near == r.t_near));
    CHECK((r2.dx == r.dx && r2.dy == r.dy && r2.dz == r.dz && r2.t_far == r.t_far));
    write_trace_hits(file.path, h);
    const TraceHits h2 = read_trace_hits(file.path);
    CHECK(
        (h2.t == h.t && h2.segment == h.segment && h2.transmittance == h.transmittance && h2.crossings == h.crossings));
}

TEST_CASE("a file that is not one of these, or not as long as it says, is refused with its name and the byte") {
    const Scratch file("refused");
    const std::string one = floats({0, 0, 0, 1, 0, 0, 0.1f});
    for (const std::string& bytes :
         {std::string(), std::string("TRSEG"), header("TRSEG002", 1) + one, header("TRSEG001", 2) + one,
          header("TRSEG001", 1) + one + "x", header("TRSEG001", ~0ull) + one, header("TRSEG001", 1ull << 61) + one,
          header("TRSEG001", 1) + floats({0, 0, 0, 1, 0, 0, -0.1f}),
          header("TRSEG001", 1) + floats({0, 0, 0, 1, 0, std::numeric_limits<float>::infinity(), 0.1f})}) {
        CAPTURE(bytes.size());
        file.write(bytes);
        const std::string message = refusal(file);
        CHECK(message.find(file.path + ": byte ") == 0);
        CHECK(message.find('\n') == std::string::npos);
    }
    CHECK_THROWS_AS(read_trace_rays("/nonexistent/rays"), InputError);
    file.write(header("TRSEG001", 0));
    CHECK(read_trace_segments(file.path).size() == 0);
}
