// SPDX-License-Identifier: MIT
#include "io/trace_files.h"

#include <array>
#include <bit>
#include <cmath>

#include "io/byte_reader.h"
#include "io/whole_file.h"

namespace tress {
namespace {

constexpr size_t kMagicBytes = 8, kHeaderBytes = 16;
constexpr uint64_t kMostSegments = 0x7fffffffu;  // two points each, numbered in 32 bits
static_assert(std::endian::native == std::endian::little, "records are written as they lie in memory");

/// Reads the header, and then records of N floats one by one: on_record(i, record).
template <size_t N, class OnCount, class OnRecord>
void read_records(const std::string& path, const char* magic, uint64_t most, const OnCount& on_count,
                  const OnRecord& on_record) {
    constexpr size_t kBatch = 4096;
    ByteReader file(path);
    std::array<char, kMagicBytes> found;
    file.read(std::span(found), "the first 8 bytes");
    if (std::string(found.data(), kMagicBytes) != magic) {
        file.seek(0, "the start");
        file.fail(std::string("not such a file, expected \"") + magic + "\"");
    }
    const auto count = file.read<uint64_t>("the number of records");
    if (count > most) file.fail(std::to_string(count) + " records, expected at most " + std::to_string(most));
    file.need(count, N * sizeof(float), "records");
    on_count(size_t(count));
    std::vector<std::array<float, N>> batch(std::min<uint64_t>(count, kBatch));
    for (uint64_t i = 0; i < count; i += batch.size()) {
        const size_t size = std::min<uint64_t>(batch.size(), count - i);
        file.read(std::span(batch[0].data(), size * N), "records");
        for (size_t k = 0; k < size; ++k) on_record(size_t(i) + k, batch[k], file);
    }
    if (file.remaining() != 0)
        file.fail(std::to_string(file.remaining()) + " bytes after the last record, expected none");
}

template <size_t N, class Record>
void write_records(const std::string& path, const char* magic, size_t count, const Record& record) {
    WholeFile file(path);
    const uint64_t records = count;
    file.write(magic, kMagicBytes);
    file.write(&records, sizeof records);
    for (size_t i = 0; i < count; ++i) {
        const std::array<float, N> values = record(i);
        file.write(values.data(), sizeof values);
    }
    file.commit();
}

template <class T>
void resize(size_t count, std::initializer_list<std::vector<T>*> arrays) {
    for (std::vector<T>* array : arrays) array->resize(count);
}

}  // namespace

TraceSegments read_trace_segments(const std::string& path) {
    TraceSegments s;
    const auto allocate = [&](size_t count) {
        resize<float>(2 * count, {&s.x, &s.y, &s.z, &s.radius});
        s.point.resize(count);
    };
    const auto store = [&](size_t i, const std::array<float, 7>& v, const ByteReader& file) {
        float sum = 0;
        for (const float value : v) sum += 0 * value;  // not a number as soon as one is not finite
        if (sum != 0 || v[6] < 0)
            file.fail("segment " + std::to_string(i) + " is not finite or of negative radius, expected neither");
        s.point[i] = uint32_t(2 * i);
        for (size_t end = 0; end < 2; ++end) {
            s.x[2 * i + end] = v[3 * end];
            s.y[2 * i + end] = v[3 * end + 1];
            s.z[2 * i + end] = v[3 * end + 2];
            s.radius[2 * i + end] = v[6];
        }
    };
    read_records<7>(path, "TRSEG001", kMostSegments, allocate, store);
    return s;
}

TraceRays read_trace_rays(const std::string& path) {
    TraceRays r;
    const std::array arrays{&r.ox, &r.oy, &r.oz, &r.t_near, &r.dx, &r.dy, &r.dz, &r.t_far};
    const auto allocate = [&](size_t count) {
        for (auto* array : arrays) array->resize(count);
    };
    const auto store = [&](size_t i, const std::array<float, 8>& v, const ByteReader&) {
        for (size_t k = 0; k < arrays.size(); ++k) (*arrays[k])[i] = v[k];
    };
    read_records<8>(path, "TRRAY001", ~0ull, allocate, store);
    return r;
}

TraceHits read_trace_hits(const std::string& path) {
    TraceHits h;
    const auto allocate = [&](size_t count) {
        resize<float>(count, {&h.t, &h.transmittance});
        resize<uint32_t>(count, {&h.segment, &h.crossings});
    };
    const auto store = [&](size_t i, const std::array<float, 4>& v, const ByteReader&) {
        h.t[i] = v[0];
        h.segment[i] = std::bit_cast<uint32_t>(v[1]);
        h.transmittance[i] = v[2];
        h.crossings[i] = std::bit_cast<uint32_t>(v[3]);
    };
    read_records<4>(path, "TRHIT001", ~0ull, allocate, store);
    return h;
}

void write_trace_segments(const std::string& path, const TraceSegments& s) {
    write_records<7>(path, "TRSEG001", s.size(), [&](size_t i) {
        const size_t p = s.point[i];
        return std::array{s.x[p], s.y[p], s.z[p], s.x[p + 1], s.y[p + 1], s.z[p + 1], s.radius[p]};
    });
}

void write_trace_rays(const std::string& path, const TraceRays& r) {
    write_records<8>(path, "TRRAY001", r.size(), [&](size_t i) {
        return std::array{r.ox[i], r.oy[i], r.oz[i], r.t_near[i], r.dx[i], r.dy[i], r.dz[i], r.t_far[i]};
    });
}

void write_trace_hits(const std::string& path, const TraceHits& h) {
    write_records<4>(path, "TRHIT001", h.size(), [&](size_t i) {
        return std::array{h.t[i], std::bit_cast<float>(h.segment[i]), h.transmittance[i],
                          std::bit_cast<float>(h.crossings[i])};
    });
}

}  // namespace tress
